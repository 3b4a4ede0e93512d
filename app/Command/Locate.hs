-- | @pra-tactile locate@: from the content of a patch to its position in the array.
module Command.Locate
  ( command,
  )
where

import AnswerText
import ArrayChoice
import Control.Monad (when)
import Data.Bifunctor (first)
import qualified Data.ByteString.Char8 as Bytes
import Data.Maybe (fromMaybe, isJust)
import Data.Text (Text)
import qualified Data.Text as Text
import ExitStatus
import Explain
import Lines
import Message
import Options
import PatchText
import PraTactile.Array (ArrayOn (..), Surface (..))
import PraTactile.Field (KnownField)
import PraTactile.Format (AnswerReport, encodeAnswer)
import PraTactile.Format.Answer.Report (invalidReport)
import PraTactile.Locate
import PraTactile.Profile
import PraTactile.Symmetry (Symmetry, identity, rotations, symmetries)
import PraTactile.Window (Mask)
import System.IO (hFlush, stdout)

data Options = Options
  { decoder :: Maybe DecoderName,
    radius :: Radius,
    -- | 'Nothing' as is usual
    doubtGiven :: Maybe Double,
    foreignThings :: Maybe Double,
    turning :: Turning,
    explained :: Explained,
    form :: AnswerForm,
    -- | 'Nothing': one a line from the standard input
    source :: Maybe [String]
  }

-- | Whether the answer is explained.
data Explained = Explained | Unexplained
  deriving stock (Eq)

command :: Mod CommandFields (IO ExitStatus)
command =
  subcommand
    "locate"
    "Tell the position of a patch of symbols in the array; rows are parted by '/' or line ends, \
    \cells by spaces; codes or powers; '?' is a cell that was not observed. Or JSON, in which a \
    \cell may be the list of the probabilities of all symbols. Several patches of one face are \
    \parted by ';', each with its displacement from a common point in front, 'ROW,COLUMN:'; the \
    \position is then that of the upper left cell of the rectangle around all, from which offsets \
    \count."
    [ "pra-tactile locate '3 2 / 3 1'",
      "pra-tactile locate 'A^2 A / A^2 1' --json",
      "pra-tactile locate '3 2 ? 1 / 3 0 2 1 / 0 1 3 ? / 1 3 2 2' --explain",
      "pra-tactile locate '[[[0,0,0.1,0.9], 2], [3, 1]]' --doubt 0.2",
      "pra-tactile locate --foreign 0.005 --doubt 0.01 '3 2 / 3 1' --json",
      "pra-tactile locate '3 2 / 3 1 ; 0,3: 1 1 / 1 1'",
      "pra-tactile locate '{\"patches\": [{\"at\": [0, 0], \"cells\": [[3, 2], [3, 1]]}, {\"at\": \
      \[0, 3], \"cells\": [[1, 1], [1, 1]]}]}' --json",
      "pra-tactile locate --orientation turned '1 0 3 3 / 0 1 1 2 / 2 3 2 0 / 2 0 1 1'",
      "pra-tactile locate --batch < patches.txt"
    ]
    (run <$> arrayChoice <*> surfaceOption <*> optionsParser)

optionsParser :: Parser Options
optionsParser =
  Options
    <$> optional decoderOption
    <*> radiusOption
      "Correct up to N wrong cells, at the risk of wrong answers (default: as many as the observed \
      \cells guarantee)"
    <*> usually
      usualDoubt
      decimalReader
      "doubt"
      "P"
      "With probabilities or --foreign: the probability of a wrong answer that is tolerated"
    <*> optional
      ( valued
          decimalReader
          "foreign"
          "P"
          "Weigh that the patch is nothing of the array's, which beforehand has this probability: \
          \its symbols independent, all equally likely (default: not weighed)"
      )
    <*> turningOption
    <*> flag
      Unexplained
      Explained
      ( long "explain"
          <> help
            "Say what the answer rests on: the cells, their equations, the distance to the next \
            \candidate"
      )
    <*> jsonSwitch "Print the answer as JSON"
    <*> ( flag'
            Nothing
            ( long "batch"
                <> help
                  "Read one patch, or several parted by ';', a line from the standard input; print \
                  \one JSON answer a line"
            )
            <|> (Just <$> some (strArgument (metavar "PATCH")))
        )

usualDoubt :: Double
usualDoubt = 0.001

-- | The probability of a wrong answer that is tolerated.
doubt :: Options -> Double
doubt = fromMaybe usualDoubt . doubtGiven

-- | @--road@.
decoderOption :: Parser DecoderName
decoderOption =
  choosing
    "road"
    [(decoderText name, name) | name <- [TableDecoder, AlgebraDecoder, SearchDecoder]]
    "road"
    "table|algebra|search"
    "How to find positions at which all observed cells agree (default: correct errors, by \
    \comparing with every position or, beyond 2^20 cells, by information sets)"
    mempty

turningOption :: Parser Turning
turningOption =
  choosing
    "choice of orientation"
    (allNamed turningName)
    "orientation"
    "upright|turned|any"
    "How patches may be seen: by any quarter turn (turned), perhaps also mirrored (any); the \
    \answer then tells the orientation, clockwise, and says where it cannot"
    (value Upright <> showDefaultWith turningName)

run :: ArrayChoice -> Maybe Surface -> Options -> IO ExitStatus
run choice surface options
  | not (doubt options >= 0 && doubt options < 1) = misused "--doubt is a probability below 1"
  | any (\p -> not (p >= 0 && p < 1)) (foreignThings options) =
    misused "--foreign is a probability below 1"
  | Just _ <-
      decoder options,
    UpTo _ <- radius options =
    misused
      "--road finds positions at which all cells agree; leave it out to correct errors with \
      \--radius"
  | Just words'@(_ : _ : _) <- source options =
    misused
      ("a patch is one argument; write it between quotation marks: '" ++ unwords words' ++ "'")
  | otherwise = do
    profile <- chosenProfile choice
    let on = fromMaybe (profileSurface profile) surface
    either unusable id
      =<< orUnusable
        profileMessage
        ( withProfile
            profile
            ( \array mask ->
                answering profile options <$> responder options profile (ArrayOn on array) mask
            )
        )

-- | The answer to what was read, in words and as JSON.
data Response = Response
  { -- | Whether some cells were given by probabilities.
    responseLikely :: Bool,
    responseAnswer :: Answer,
    responseLines :: [String],
    responseReport :: AnswerReport
  }

-- | How patches, as they are written, are answered; the answering function refuses in words what is
-- no patch. It is itself refused, before any patch is read, where the array has no locator on this
-- surface. Tables of the array are computed once, when the first patch needs them.
responder ::
  KnownField k =>
  Options ->
  Profile ->
  ArrayOn k ->
  Mask ->
  Either String (Text -> Either String Response)
responder options profile on@(ArrayOn _ array) mask = do
  _ <- first locatorMessage (decoderFor theLocator (radius options))
  pure $ \text -> do
    written <- readPatches text
    let query = queryOf written
        asked = Asked (querySymmetries query) (writtenDisplaced written)
        displacements = map fst (writtenPatches written)
    answer <- first locatorMessage (locate theLocator query)
    seen <- first locatorMessage (agreedSymbols query)
    let inWords = answerText asked answer
        explanation
          | explained options == Unexplained = Nothing
          | otherwise =
            Just (explainAnswer array mask asked displacements seen (doubt options) answer)
    pure
      Response
        { responseLikely = or [any isLikely p | (_, p) <- writtenPatches written],
          responseAnswer = answer,
          responseLines = inWords : fromMaybe [] explanation,
          responseReport = reportOf profile asked displacements explanation answer
        }
  where
    isLikely cell = case cell of
      Probabilities _ -> True
      Symbol _ -> False
    theLocator = locator (decoder options) (profilePacking profile) on mask
    queryOf written =
      Query
        { queryPatches = writtenPatches written,
          querySymmetries = symmetriesOf (turning options),
          queryRadius = radius options,
          queryDoubt = doubt options,
          queryForeign = foreignThings options,
          -- Of symbols that are told nobody knows how they looked.
          queryForeignShape = -1 / 0,
          queryPrior = Nothing
        }

answering :: Profile -> Options -> (Text -> Either String Response) -> IO ExitStatus
answering profile options respond = case source options of
  Nothing -> batch profile respond
  Just given -> do
    response <- orUnusable id (respond (Text.pack (unwords given)))
    if responseLikely response
      then
        leaveOut
          "probabilities are weighed, and no wrong cells are counted"
          [("--radius", radius options /= Guaranteed)]
      else
        leaveOut
          "--doubt is weighed of probabilities, or with --foreign"
          [("--doubt", isJust (doubtGiven options) && null (foreignThings options))]
    printAs
      (form options)
      (unlines (responseLines response))
      (encodeAnswer (responseReport response))
    when (form options == AsText) (mapM_ warn (weaknesses (responseAnswer response)))
    pure (statusOf response)

-- | That random symbols would be located as well, and what nothing checks.
weaknesses :: Answer -> [String]
weaknesses answer = case answerOutcome answer of
  Unique _ _ ->
    maybe [] pure (answerChance answer >>= chanceWarning)
      ++ map ("warning: " ++) (foldMap unchecked (answerChecks answer))
  _ -> []

-- | One line after another, each answered at once; the worst status of all.
batch :: Profile -> (Text -> Either String Response) -> IO ExitStatus
batch profile respond = forLines answerLine Answered
  where
    answerLine worst given = do
      let answer = lineText given >>= respond
      Bytes.putStrLn (encodeAnswer (either (invalidReport profile) responseReport answer))
      hFlush stdout
      pure (max worst (either (const Unusable) statusOf answer))

statusOf :: Response -> ExitStatus
statusOf response = case answerOutcome (responseAnswer response) of
  Unique _ _ -> Answered
  _ -> NotAnswered

-- | In which orientations patches may be seen.
data Turning
  = Upright
  | -- | by any number of quarter turns
    Turned
  | -- | and perhaps mirrored
    Any
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | As the command line has it.
turningName :: Turning -> String
turningName how = case how of
  Upright -> "upright"
  Turned -> "turned"
  Any -> "any"

symmetriesOf :: Turning -> [Symmetry]
symmetriesOf how = case how of
  Upright -> [identity]
  Turned -> rotations
  Any -> symmetries
