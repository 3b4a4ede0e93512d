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
    -- | 'Nothing': the default
    doubtGiven :: Maybe Double,
    foreignThings :: Maybe Double,
    turning :: Turning,
    explained :: Explained,
    form :: AnswerForm,
    -- | 'Nothing': patches on the standard input, one a line
    source :: Maybe [String]
  }

-- | Whether the answer is explained.
data Explained = Explained | Unexplained
  deriving stock (Eq)

command :: Subcommand
command =
  subcommand
    "locate"
    "Find the position of a patch of symbols in the array"
    "Find where in the array a patch of symbols lies. Rows are separated by '/' or line ends, \
    \cells by spaces. A symbol is a code (2) or a power (A^2); '?' is a cell that was not \
    \observed. In JSON a cell may also be a list of the probabilities of all symbols. Several \
    \patches of one face are separated by ';'; each has its displacement from a common point in \
    \front, as in '0,3: 1 1'. The position is then that of the upper left cell of the rectangle \
    \around all patches, and offsets count from there."
    [arrayGroup]
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
    (run <$> surfaceOption <*> optionsParser <*> arrayChoice)

optionsParser :: Parser Options
optionsParser =
  Options
    <$> optional decoderOption
    <*> radiusOption
      "Correct up to N wrong cells; above the default, answers may be wrong (default: as many as \
      \the observed cells guarantee)"
    <*> usually
      usualDoubt
      decimalReader
      "doubt"
      "P"
      "With probabilities or --foreign: the largest tolerated probability that the answer is wrong"
    <*> optional
      ( valued
          decimalReader
          "foreign"
          "P"
          "Prior probability that the patch is not from the array; its symbols are then \
          \independent and uniform (default: this is not considered)"
      )
    <*> turningOption
    <*> flag
      Unexplained
      Explained
      ( long "explain"
          <> help
            "Say what the answer is based on: the cells, their equations, the distance to the next \
            \candidate"
      )
    <*> jsonSwitch "Print the answer as JSON"
    <*> ( flag'
            Nothing
            ( long "batch"
                <> help
                  "Read lines from the standard input, each a patch, or several separated by ';'; \
                  \print one line of JSON for each"
            )
            <|> ( Just
                    <$> some
                      ( strArgument
                          ( metavar "PATCH"
                              <> help "The patch, one argument between quotation marks"
                          )
                      )
                )
        )

usualDoubt :: Double
usualDoubt = 0.001

-- | The largest tolerated probability of a wrong answer.
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
    "Find the positions at which all observed cells agree, by this method (default: correct \
    \errors, by comparing with every position, or by information sets beyond 2^20 cells)"
    mempty

turningOption :: Parser Turning
turningOption =
  choosing
    "choice of orientation"
    (allNamed turningName)
    "orientation"
    "upright|turned|any"
    "In which orientations patches may be seen: upright, any quarter turn (turned), or also \
    \mirrored (any). The answer then has the orientation, clockwise, unless several fit"
    (value Upright <> showDefaultWith turningName)

run :: Maybe Surface -> Options -> ArrayChoice -> IO ExitStatus
run surface options choice
  | not (doubt options >= 0 && doubt options < 1) =
    misused
      "--doubt must be a probability from 0 to below 1"
  | any (\p -> not (p >= 0 && p < 1)) (foreignThings options) =
    misused "--foreign must be a probability from 0 to below 1"
  | Just _ <-
      decoder options,
    UpTo _ <- radius options =
    misused
      "--road finds positions at which all cells agree; leave it out to correct errors by --radius"
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

-- | The answer to a patch, in words and as JSON.
data Response = Response
  { -- | Whether some cells were given by probabilities.
    responseLikely :: Bool,
    responseAnswer :: Answer,
    responseLines :: [String],
    responseReport :: AnswerReport
  }

-- | The function that answers written patches, and refuses in words a text that is no patch. There
-- is none, whatever the patches, if the array has no locator on this surface. Tables of the array
-- are computed once, when the first patch needs them.
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
          -- Stated symbols have no images that could look unlike all shapes.
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
          "for probabilities no wrong cells are counted"
          [("--radius", radius options /= Guaranteed)]
      else
        leaveOut
          "--doubt needs probabilities or --foreign"
          [("--doubt", isJust (doubtGiven options) && null (foreignThings options))]
    printAs
      (form options)
      (unlines (responseLines response))
      (encodeAnswer (responseReport response))
    when (form options == AsText) (mapM_ warn (weaknesses (responseAnswer response)))
    pure (statusOf response)

-- | Warnings: that random symbols would be located, too, and what no parity check covers.
weaknesses :: Answer -> [String]
weaknesses answer = case answerOutcome answer of
  Unique _ _ ->
    maybe [] pure (answerChance answer >>= chanceWarning)
      ++ map ("warning: " ++) (foldMap unchecked (answerChecks answer))
  _ -> []

-- | Answer one line after another, each at once; the status is the worst of all.
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

-- | The name of a choice on the command line.
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
