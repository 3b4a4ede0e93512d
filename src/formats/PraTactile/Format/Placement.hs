{-# LANGUAGE OverloadedStrings #-}

-- | Placements as JSON, @pra-tactile/placement/1@: what of one cannot be computed. The profile, the
-- distances between symbols, the objects, and of each laid face the vertex at which its frame
-- begins, where its block of cells lies, and which cells it takes.
module PraTactile.Format.Placement
  ( encodePlacement,
    decodePlacement,
    PlacementFileError (..),

    -- * As part of other texts
    Drawing (..),
    drawing,
    drawnPlacement,
    drawingKeys,
  )
where

import Control.Monad (when)
import Data.Bifunctor (first)
import Data.ByteString (ByteString)
import Data.List (genericDrop, genericLength, nub)
import Data.Traversable (for)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Format.Error
import PraTactile.Format.Json.Codec hiding (shape)
import PraTactile.Format.Object (faceKeys)
import PraTactile.Format.Profile (profileCodec)
import PraTactile.Format.Solid.Json (describedCodec, exact, tooFine)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Profile

-- | Why a text holds no placement.
data PlacementFileError
  = -- | It has another form.
    PlacementMisfit FormatError
  | -- | The coordinates of the object of this name have no common denominator of less than 20 000
    -- bits.
    ObjectTooFine ObjectName
  | -- | The object of this name is no solid.
    ObjectBroken ObjectName Defect
  | -- | Its faces cannot be laid so.
    PlacementRefused PlacementError
  deriving stock (Eq, Show)

-- | What the text has.
data Stated = Stated
  { statedProfile :: Profile,
    statedPitch :: Pitch,
    statedObjects :: [Description],
    statedLayings :: [Drawing]
  }

-- | A placement on the array of a profile, on one line, without its end.
encodePlacement :: Profile -> Placement -> ByteString
encodePlacement profile place =
  writeLine
    statedKeys
    Stated
      { statedProfile = profile,
        statedPitch = placementPitch place,
        statedObjects = map description (placementSolids place),
        statedLayings = map (drawing . layingOf) (laidFaces place)
      }

-- | The placement in a JSON text that 'encodePlacement' made, and the profile of its array. Refuses
-- another schema, keys that are missing or have other values, and what 'solid' and 'placement'
-- refuse; whether the profile describes an array is for 'withProfile' to say.
decodePlacement :: ByteString -> Either PlacementFileError (Profile, Placement)
decodePlacement bytes = do
  stated <- first PlacementMisfit (decodeWith statedKeys bytes)
  let profile = statedProfile stated
  (,) profile
    <$> drawnPlacement
      (profileShape profile)
      (statedPitch stated)
      (statedObjects stated)
      (statedLayings stated)

-- | These objects on an array of this shape, with these distances between symbols, laid as it is
-- drawn.
drawnPlacement ::
  Shape -> Pitch -> [Description] -> [Drawing] -> Either PlacementFileError Placement
drawnPlacement shape between described drawn = do
  objects <- for described $ \one -> do
    when (tooFine one) (Left (ObjectTooFine (describedName one)))
    first (ObjectBroken (describedName one)) (solid one)
  first PlacementRefused (traverse (undrawn between) drawn >>= placement shape between objects)

statedKeys :: Keys Stated Stated
statedKeys =
  schemaKey "pra-tactile/placement/1"
    *> ( Stated
           <$> key "profile" profileCodec statedProfile
           <*> key "pitch_mm" pitch statedPitch
           <*> key "objects" (listOf describedCodec) statedObjects
           <*> key "layings" (listOf (object drawingKeys)) statedLayings
       )
  where
    pitch = via (\(Pitch right down) -> (right, down)) (Right . uncurry Pitch) (pairOf exact)

-- | A laying with its whole block.
data Drawing = Drawing
  { drawnFace :: Face,
    drawnRow :: Integer,
    drawnColumn :: Integer,
    drawnMargin :: Maybe (Rational, Rational),
    drawnCells :: [String]
  }
  deriving stock (Eq, Show)

-- | Of a laid face its object and vertices from the first of its frame on; where its block's upper
-- left cell lies, which may be outside of the array where the face does not take it; the block's
-- margin from the first vertex, null where it is centred; and its cells, drawn: a text a row, @#@
-- for a cell that the face takes.
drawingKeys :: Keys Drawing Drawing
drawingKeys =
  Drawing
    <$> withKeys drawnFace faceKeys
    <*> key "row" integer drawnRow
    <*> key "column" integer drawnColumn
    <*> key "margin_mm" (nullable (pairOf exact)) drawnMargin
    <*> key "cells" (such evenly NotDrawnCells (listOf text)) drawnCells
  where
    evenly lines' =
      length (nub (map length lines')) <= 1 && all (all (`elem` ("#." :: String))) lines'

drawing :: Laying -> Drawing
drawing (Laying face (Position r c) anchor given) =
  Drawing
    { drawnFace = face,
      drawnRow = toInteger r - above,
      drawnColumn = toInteger c - before,
      drawnMargin = margin,
      drawnCells =
        [ [if has (i - above) (j - before) then '#' else '.' | j <- [0 .. wide - 1]]
          | i <- [0 .. high - 1]
        ]
    }
  where
    Shape rows' columns' = blockShape given
    ((high, wide), (above, before), margin) = case anchor of
      Centred -> ((toInteger rows', toInteger columns'), (0, 0), Nothing)
      CentredPart whole from -> (whole, from, Nothing)
      Margin x y -> ((toInteger rows', toInteger columns'), (0, 0), Just (x, y))
    has i j = i >= 0 && j >= 0 && hasCell given (Position (fromInteger i) (fromInteger j))

-- | What is drawn above and left of the array's sheet is left away; refuses cells that are taken
-- there.
undrawn :: Pitch -> Drawing -> Either PlacementError Laying
undrawn (Pitch right down) (Drawing face r c margin lines')
  | beyond = Left (OutsideArray face at shape)
  | otherwise = Right (Laying face at anchor (blockOf shape cells))
  where
    (above, before) = (max 0 (negate r), max 0 (negate c))
    at = Position (fromInteger (max 0 r)) (fromInteger (max 0 c))
    kept = map (genericDrop before) (genericDrop above lines')
    shape = Shape (genericLength kept) (genericLength (concat (take 1 kept)))
    taken = length . filter (== '#') . concat
    beyond = taken kept /= taken lines'
    cells = [Position i j | (i, line) <- zip [0 ..] kept, (j, '#') <- zip [0 ..] line]
    anchor = case margin of
      Just (x, y) -> Margin (x + fromInteger before * right) (y + fromInteger above * down)
      Nothing
        | (above, before) == (0, 0) -> Centred
        | otherwise ->
          CentredPart (genericLength lines', genericLength (concat (take 1 lines'))) (above, before)
