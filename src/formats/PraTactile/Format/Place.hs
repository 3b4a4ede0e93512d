{-# LANGUAGE OverloadedStrings #-}

-- | The JSON that the command @place@ prints.
module PraTactile.Format.Place
  ( PlaceReport (..),
    ReportedLaying (..),
    reportedSymbols,
    PlaceOutcome (..),
    MaskProof (..),
    outcomeName,
    reasonName,
    nothingCarriedName,
    encodePlace,
  )
where

import Data.Aeson (Value (..), (.=))
import qualified Data.Aeson as Aeson
import Data.ByteString (ByteString)
import Data.List (genericLength)
import Numeric.Natural (Natural)
import PraTactile.Array (Position)
import PraTactile.Format.Json
import PraTactile.Format.Json.Codec (writeObject)
import PraTactile.Format.Placement (drawing, drawingKeys)
import PraTactile.Format.Profile
import PraTactile.Object.Packing (Reason (..))
import PraTactile.Object.Placement (Laying (..), blockCells)
import PraTactile.Object.Placement.Windows
import PraTactile.Object.WingedEdge (FaceName)
import PraTactile.Profile

-- | The result of a search for a placement.
data PlaceReport = PlaceReport
  { placeOutcome :: PlaceOutcome,
    -- | the name of the reason why there is no placement, if that is proved: by 'reasonName', or
    -- 'nothingCarriedName'
    placeReason :: Maybe String,
    -- | the number of cells of the array
    placeCells :: Natural,
    -- | the least number of cells that the faces take
    placeNeeded :: Natural,
    placeProfile :: Profile,
    placeLayings :: [ReportedLaying],
    -- | how many windows of the array lie on faces; 'Nothing' if they were not counted
    placeWindows :: Maybe WindowCounts,
    -- | the width and height, in taxels, of the least press that always has a whole window
    placePress :: (Integer, Integer)
  }

-- | A laid face.
data ReportedLaying = ReportedLaying
  { reportedLaying :: Laying,
    -- | what is proved about its cells
    reportedProof :: MaskProof,
    -- | the greatest number of symbols that the face can have, and the vertex at which its frame
    -- then begins; 'Nothing' if that takes long to compute
    reportedMost :: Maybe (Integer, FaceName)
  }

-- | The number of symbols of a laid face.
reportedSymbols :: ReportedLaying -> Integer
reportedSymbols = genericLength . blockCells . layBlock . reportedLaying

-- | Whether there is a placement.
data PlaceOutcome = IsPlaced | IsImpossible | IsNotFound
  deriving stock (Eq, Show, Enum, Bounded)

-- | The rank of the contents of a face's cells, and their distance with the cells whose loss it
-- does not bear; 'Nothing' if they were not computed.
data MaskProof = MaskProof
  { maskRank :: Maybe Natural,
    maskDistance :: Maybe (Natural, [Position])
  }
  deriving stock (Eq, Show)

-- | The stable name of an outcome.
outcomeName :: PlaceOutcome -> String
outcomeName outcome = case outcome of
  IsPlaced -> "placed"
  IsImpossible -> "impossible"
  IsNotFound -> "not-found"

-- | The stable name of a reason why there is no placement.
reasonName :: Reason -> String
reasonName reason = case reason of
  TakenOutside _ -> "laid-outside"
  TakenOverlaps _ -> "laid-overlaps"
  PieceTooLarge _ -> "face-too-large"
  TooFewCells _ _ -> "too-few-cells"
  NoRoom _ -> "no-room"
  Exhausted -> "exhausted"

-- | The stable name of one more reason: no face has room for a symbol.
nothingCarriedName :: String
nothingCarriedName = "no-symbols"

-- | The report as one line, without its line end.
encodePlace :: PlaceReport -> ByteString
encodePlace report =
  encodeSchema "place/1" $
    "outcome" .= outcomeName (placeOutcome report)
      <> "reason" .= placeReason report
      <> "cells" .= naturalValue (placeCells report)
      <> "cells_needed" .= naturalValue (placeNeeded report)
      <> "profile" .= profileValue (placeProfile report)
      <> "layings" .= map layingValue (placeLayings report)
      <> "windows" .= fmap windowsValue (placeWindows report)
      <> "press_taxels" .= placePress report
  where
    windowsValue (WindowCounts onFaces straddling onNone) =
      Aeson.object
        ["on_faces" .= onFaces, "straddling" .= straddling, "on_none" .= onNone]
    layingValue reported =
      let MaskProof rank apart = reportedProof reported
       in Object
            ( writeObject drawingKeys (drawing (reportedLaying reported))
                <> "symbols" .=? reportedSymbols reported
                <> "most_symbols" .=? fmap fst (reportedMost reported)
                <> "rank" .=? fmap naturalValue rank
                <> "distance" .=? fmap (naturalValue . fst) apart
                <> "failing_erasure" .=? fmap (map positionListValue . snd) apart
            )
    name .=? part = name Aeson..= part
