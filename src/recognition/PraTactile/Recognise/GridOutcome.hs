{-# OPTIONS_HADDOCK hide #-}

-- | Whether the likeliest position of a grid is an answer, and if not, why. It takes two judgements
-- that agree.
--
-- By the probabilities of all symbols and parts, the position must be likely enough. And of the
-- certain symbols, no more may contradict it than the minimum distance of their cells lets be
-- wrong. At least one that agrees must be complete, since parts are not compared with other shapes.
--
-- The reason of a refusal is looked for in the symbols that the network knows, without
-- probabilities.
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

-- | Where the grid's upper left cell is, or what stands against an answer.
data GridOutcome
  = Placed Position
  | -- | several positions agree with all that is known
    Undecided [Position]
  | -- | too many symbols lie another way up than the rest
    WrongWayUp
  | -- | too many symbols lie off the grid of the rest
    OffTheGrid
  | -- | groups of symbols lead to different places
    GroupsApart
  | Unplaced Reason
  | -- | what was seen cannot be decoded
    Undecoded LocatorError
  deriving stock (Eq, Show)

-- | The outcome of a grid, given the array's answer for it; 'Nothing' stands for a grid without
-- cells.
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
    placedAt findings witnesses position (standingAt reader witnesses position)
    where
      position = candidatePosition candidate
  _ -> whyUnlikely findings witnesses
  where
    findings = findingsOf reader tolerance face

-- | The outcome where this position is likely enough, and the witnesses stand to it so.
placedAt :: Findings -> Witnesses -> Position -> Standing -> GridOutcome
placedAt findings witnesses position (Standing agreeing wrong)
  | genericLength wrong > witnessesRadius witnesses =
    whyContradicted findings witnesses (genericLength wrong)
  | any ((>= 1) . readSeen) agreeing = Placed position
  | otherwise = Unplaced BelowThreshold

-- | What the symbols that the network knows say without probabilities.
data Findings = Findings
  { -- | where they are together; 'Nothing' where that cannot be decoded
    foundTogether :: Maybe (Outcome Position),
    -- | whether some groups of them are at different places
    foundApart :: Bool
  }

-- | The findings on a face.
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

-- | Where cells are by the symbols of this orientation that the network knows. 'Nothing' where that
-- cannot be decoded.
locatedExactly ::
  KnownField k => Recogniser k -> Tolerance -> Symmetry -> Cells -> Maybe (Outcome Position)
locatedExactly reader tolerance orientation cells = case knownPatch cells orientation of
  Left _ -> Just (Refused TooFewCells)
  Right known ->
    either (const Nothing) (Just . fmap candidatePosition . answerOutcome) $
      locate
        (recogniserLocator reader)
        (onePatch (Symbol <$> known)) {queryRadius = toleratedErrors tolerance}

-- | Why there is no answer where a position is likely, but this many symbols contradict it.
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

-- | Why there is no answer where no position is likely enough.
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
