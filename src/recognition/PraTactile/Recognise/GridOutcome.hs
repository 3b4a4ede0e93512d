{-# OPTIONS_HADDOCK hide #-}

-- | Decides whether the likeliest position of a grid is an answer, and if not, why. Two independent
-- judgements must agree.
--
-- By the probabilities of all symbols and parts, the position must be likely enough. And among the
-- certain symbols, the number that contradict it must be within what the minimum distance of their
-- cells can correct. At least one agreeing symbol must be complete, because parts are not compared
-- with other shapes.
--
-- The reason of a refusal comes from the symbols that the network knows, without probabilities.
module PraTactile.Recognise.GridOutcome
  ( GridOutcome (..),
    gridOutcome,
  )
where

import Data.List (genericLength)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)
import qualified Data.Set as Set
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Position
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Recognise.SymbolBelief
import PraTactile.Recognise.Tolerance
import PraTactile.Recognise.Witnesses
import PraTactile.Symmetry

-- | The outcome for a grid: a position, or why there is none.
data GridOutcome
  = -- | the position of the grid's upper left cell in the array
    Placed Position
  | -- | several positions agree with all known symbols
    Undecided [Position]
  | -- | too many symbols lie another way up than the rest
    WrongWayUp
  | -- | too many symbols lie off the grid of the rest
    OffTheGrid
  | -- | groups of symbols lead to different places
    GroupsApart
  | -- | any other reason
    Unplaced Reason
  | -- | the decoder refuses the grid
    Undecoded LocatorError
  deriving stock (Eq, Show)

-- | The outcome of a grid. Arguments: the recogniser; the tolerance; the grid on the face; its
-- witnesses; the decoder's answer for the grid, 'Nothing' for a grid without cells.
gridOutcome ::
  KnownField k =>
  Recogniser k ->
  Tolerance ->
  GridOnFace ->
  Witnesses ->
  Maybe (Either LocatorError Answer) ->
  GridOutcome
gridOutcome reader tolerance face witnesses answered = case fmap answerOutcome <$> answered of
  Just (Left why) -> Undecoded why
  Just (Right (Unique candidate _)) ->
    placedAt findings witnesses position (witnessesAt reader witnesses position)
    where
      position = candidatePosition candidate
  _ -> whyUnlikely findings witnesses
  where
    findings = findingsOf reader tolerance face

-- | The outcome for a position that is likely enough. Arguments: the findings of the known symbols;
-- the witnesses; the position; the witnesses for and against it.
placedAt :: Findings -> Witnesses -> Position -> WitnessSplit -> GridOutcome
placedAt findings witnesses position (WitnessSplit agreeing wrong)
  | genericLength wrong > witnessesRadius witnesses =
    whyContradicted findings witnesses (genericLength wrong)
  | any ((>= 1) . readSeen) agreeing = Placed position
  | otherwise = Unplaced BelowThreshold

-- | What the symbols that the network knows imply, without probabilities.
data Findings = Findings
  { -- | the position of all known symbols when they are decoded together; 'Nothing' if the decoder
    -- refuses them
    foundTogether :: Maybe (Outcome Position),
    -- | whether some groups of known symbols lead to different positions when each is decoded alone
    foundApart :: Bool
  }

-- | The findings for a grid on a face.
findingsOf :: KnownField k => Recogniser k -> Tolerance -> GridOnFace -> Findings
findingsOf reader tolerance face =
  Findings
    { foundTogether = located (onFaceCells face),
      foundApart = or (zipWith (/=) places (drop 1 places))
    }
  where
    located = locatedExactly reader tolerance (onFaceOrientation face)
    places = mapMaybe (onlyPlace . located . ofGroup) (onFaceGroups face)
    ofGroup numbers =
      Map.map (filter ((`Set.member` numbers) . readNumber)) (onFaceCells face)
    onlyPlace found = case found of
      Just (Unique place _) -> Just place
      _ -> Nothing

-- | Decodes cells by the symbols in them that the network knows in this orientation. 'Nothing' if
-- the decoder refuses them.
locatedExactly ::
  KnownField k => Recogniser k -> Tolerance -> Symmetry -> Cells -> Maybe (Outcome Position)
locatedExactly reader tolerance orientation cells = case knownPatch cells orientation of
  Left _ -> Just (Refused TooFewCells)
  Right known ->
    either (const Nothing) (Just . fmap candidatePosition . answerOutcome) $
      locate
        (recogniserLocator reader)
        (onePatch (Symbol <$> known)) {queryRadius = toleratedErrors tolerance}

-- | Why there is no answer although a position is likely: this many symbols contradict it.
whyContradicted :: Findings -> Witnesses -> Natural -> GridOutcome
whyContradicted findings witnesses wrong
  | accountFor (witnessesOtherWayUp witnesses) = WrongWayUp
  | accountFor (witnessesStray witnesses) = OffTheGrid
  | foundApart findings = GroupsApart
  | Just (Refused reason) <- foundTogether findings = Unplaced reason
  | otherwise = Unplaced Contradiction
  where
    accountFor symbols =
      not (null symbols) && wrong <= witnessesRadius witnesses + genericLength symbols

-- | Why there is no answer when no position is likely enough.
whyUnlikely :: Findings -> Witnesses -> GridOutcome
whyUnlikely findings witnesses
  | genericLength (witnessesOtherWayUp witnesses) > witnessesRadius witnesses = WrongWayUp
  | otherwise = case foundTogether findings of
    Nothing -> Unplaced BelowThreshold
    Just (Unique _ _) -> Unplaced BelowThreshold
    Just (Ambiguous places (_ : _)) -> Undecided places
    Just (Refused reason)
      | reason `notElem` [TooFewCells, NoCompleteWindow] ->
        if foundApart findings then GroupsApart else Unplaced reason
    _ -> Unplaced NoCompleteWindow
