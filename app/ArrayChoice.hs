-- | The options that choose the array, the same in every command: @--q --modulus --polynomial
-- --shape --window --state@, or @--profile FILE@, or none, which is the canonical profile; and
-- @--folding@.
module ArrayChoice
  ( ArrayChoice,
    arrayChoice,
    arrayGroup,
    nothingChosen,
    unsaid,
    chosenProfile,
    chosenSequence,
    chosenProfileFor,
    orderAlone,
    choiceBesideFile,
  )
where

import Data.Maybe (fromMaybe, isJust)
import ExitStatus
import FormatFile (readProfile)
import Message (profileMessage)
import Numeric.Natural (Natural)
import Options
import PraTactile.Array (Folding, Shape (..))
import PraTactile.Profile

-- | The options about the array.
data ArrayChoice = ArrayChoice
  { choiceOrder :: Maybe Natural,
    choiceModulus :: Maybe [Natural],
    choicePolynomial :: Maybe [Natural],
    choiceShape :: Maybe Shape,
    choiceWindow :: Maybe Shape,
    choiceState :: Maybe [Natural],
    choiceFolding :: Maybe Folding,
    choiceFile :: Maybe FilePath
  }
  deriving stock (Eq, Show)

-- | No option about the array is given.
unsaid :: ArrayChoice
unsaid = ArrayChoice Nothing Nothing Nothing Nothing Nothing Nothing Nothing Nothing

-- | Whether no option about the array is given.
nothingChosen :: ArrayChoice -> Bool
nothingChosen = (== unsaid)

-- | The options, all of them optional.
arrayChoice :: Parser ArrayChoice
arrayChoice =
  ArrayChoice
    <$> optional orderOption
    <*> modulusOption
    <*> numbers
      "polynomial"
      "C0,C1,.."
      "Primitive characteristic polynomial over GF(q): codes of its coefficients, constant term \
      \first; monic"
    <*> shape "shape" "Shape of the array"
    <*> shape
      "window"
      "Shape of the window (default: inferred if the number of rows is q^k1 - 1)"
    <*> numbers
      "state"
      "S0,S1,.."
      "Initial state of the shift register, as codes (default: 0,..,0,1)"
    <*> foldingOption
      "How the sequence fills the array: diagonal, on the torus, or row-major, on the twisted \
      \torus (default: diagonal)"
    <*> optionalFile
      "profile"
      "FILE"
      "Take the whole array from a profile, a JSON file as 'profile' prints it"
  where
    numbers name meta = optional . valued numbersReader name meta
    shape name = optional . valued shapeReader name "ROWSxCOLUMNS"

-- | The options of 'arrayChoice', as a group of a command's help.
arrayGroup :: Group
arrayGroup =
  Group
    "The array (default: that of the paper)"
    (words "q modulus polynomial shape window state folding profile")

-- | The profile chosen; leaves with status 2 and the reason if the choice is impossible.
chosenProfile :: ArrayChoice -> IO Profile
chosenProfile choice = case choice of
  ArrayChoice Nothing Nothing Nothing Nothing Nothing Nothing Nothing (Just file) ->
    readProfile file
  ArrayChoice {choiceFile = Just _} ->
    misused
      "--profile FILE already chooses the array; leave out --q, --modulus, --polynomial, --shape, \
      \--window, --state and --folding"
  ArrayChoice Nothing Nothing Nothing Nothing Nothing Nothing folding Nothing ->
    pure (maybe id foldedBy folding canonicalProfile)
  ArrayChoice {choiceOrder = Just q, choicePolynomial = Just h, choiceShape = Just shape} ->
    maybe id foldedBy (choiceFolding choice)
      <$> orUnusable
        profileMessage
        ( chooseProfile
            (profileChoice q h shape)
              { chosenModulus = choiceModulus choice,
                chosenWindow = choiceWindow choice,
                chosenState = choiceState choice
              }
        )
  _ ->
    misused
      ( "to choose an array, give --q, --polynomial and --shape together (missing: "
          ++ missing
          ++ ")"
      )
  where
    missing =
      unwords
        ( ["--q" | Nothing <- [choiceOrder choice]]
            ++ ["--polynomial" | Nothing <- [choicePolynomial choice]]
            ++ ["--shape" | Nothing <- [choiceShape choice]]
        )

-- | The profile chosen, with a window of this extent in the place of @--window@; for commands whose
-- @--mask@ draws the window.
chosenProfileFor :: Shape -> ArrayChoice -> IO Profile
chosenProfileFor extent choice = case choice of
  ArrayChoice {choiceWindow = Just _} ->
    misused "--mask already says what a window is; leave out --window"
  ArrayChoice {choiceShape = Just _} -> chosenProfile choice {choiceWindow = Just extent}
  _ -> (\profile -> profile {profileWindow = extent}) <$> chosenProfile choice

-- | q for a command that chooses the array itself: 4 unless @--q@ is given. Refuses other options
-- about the array.
orderAlone :: ArrayChoice -> IO Natural
orderAlone choice
  | choice {choiceOrder = Nothing} == unsaid = pure (fromMaybe 4 (choiceOrder choice))
  | otherwise =
    misused
      "--smallest looks for the array; of the array's options, beside it only --q may be given"

-- | q and the window, if they are given, for a command whose file holds the array. Refuses other
-- options about the array.
choiceBesideFile :: ArrayChoice -> Either String (Maybe Natural, Maybe Shape)
choiceBesideFile choice
  | choice {choiceOrder = Nothing, choiceWindow = Nothing} == unsaid =
    Right (choiceOrder choice, choiceWindow choice)
  | otherwise =
    Left
      "FILE already holds the array; of the array's options, only --q and --window (or --mask) \
      \may be given with it"

-- | The profile chosen, for a command that uses only the sequence: without a shape, all terms lie
-- in one row.
chosenSequence :: ArrayChoice -> IO Profile
chosenSequence choice = case choice of
  ArrayChoice
    { choiceOrder = Just q,
      choicePolynomial = Just h,
      choiceShape = Nothing,
      choiceFile = Nothing
    } -> do
      leaveOut
        "without --shape there is no array"
        [ ("--window", isJust (choiceWindow choice)),
          ("--folding", isJust (choiceFolding choice))
        ]
      chosenProfile
        choice
          { choiceShape = Just (Shape 1 (q ^ (max 1 (length h) - 1) - 1)),
            choiceWindow = Just (Shape 1 1)
          }
  _ -> chosenProfile choice
