{-# LANGUAGE OverloadedStrings #-}

-- | Placements as JSON, @pra-tactile/placement/1@. The file has only what cannot be computed: the
-- profile, the distances between symbols, the objects, and the laid faces. A laid face has the
-- vertex at which its frame begins. It also has the place of its block of cells in the array, and
-- the cells of the block that it takes.
module PraTactile.Format.Placement
  ( encodePlacement,
    decodePlacement,
    PlacementFileError (..),

    -- * Parts of other formats
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

-- | Why a text is refused as a placement.
data PlacementFileError
  = -- | It does not fit the format.
    PlacementMisfit FormatError
  | -- | The coordinates of the named object have no common denominator below 2^20000.
    ObjectTooFine ObjectName
  | -- | The named object is not a solid.
    ObjectBroken ObjectName Defect
  | -- | The faces cannot be laid as the text says.
    PlacementRefused PlacementError
  deriving stock (Eq, Show)

-- | The contents of a placement's text.
data Stated = Stated
  { statedProfile :: Profile,
    statedPitch :: Pitch,
    statedObjects :: [Description],
    statedLayings :: [Drawing]
  }

-- | A placement on a profile's array, as one line without its line end.
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

-- | Reads the JSON of 'encodePlacement': the placement and the profile of its array. Refuses
-- another schema, missing keys, invalid values, and what 'solid' and 'placement' refuse. It does
-- not check the profile; 'withProfile' does.
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

-- | The placement of objects. Arguments: the array's shape; the distances between symbols; the
-- objects' descriptions; the drawings of their laid faces. Refuses objects whose coordinates are
-- too fine or that are no solids, and what 'placement' refuses.
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

-- | A laid face, with the drawing of its whole block, also of cells outside the array.
data Drawing = Drawing
  { drawnFace :: Face,
    -- | the row of the block's upper left cell in the array; negative if it is above it
    drawnRow :: Integer,
    -- | the column of that cell; negative if it is left of the array
    drawnColumn :: Integer,
    -- | the block's upper left corner, in millimetres right of and below the face's first vertex;
    -- 'Nothing' if the block is centred on the face
    drawnMargin :: Maybe (Rational, Rational),
    -- | the block row by row, with @#@ for a cell that the face takes and @.@ for any other
    drawnCells :: [String]
  }
  deriving stock (Eq, Show)

-- | The keys of a laid face. @object@ and @face@: the object's name, and the names of the face's
-- vertices beginning with the first of its frame. @row@ and @column@: the cell at the block's upper
-- left, which may be outside the array if the face does not take it. @margin_mm@: the block's
-- margin right of and below the first vertex, null if the block is centred. @cells@: the drawing,
-- one text per row, with @#@ for a cell that the face takes.
drawingKeys :: Keys Drawing Drawing
drawingKeys =
  Drawing
    <$> withKeys drawnFace faceKeys
    <*> key "row" integer drawnRow
    <*> key "column" integer drawnColumn
    <*> key "margin_mm" (nullable (pairOf exact)) drawnMargin
    <*> key "cells" (satisfying evenly NotDrawnCells (listOf text)) drawnCells
  where
    evenly lines' =
      length (nub (map length lines')) <= 1 && all (all (`elem` ("#." :: String))) lines'

-- | The drawing of a laid face.
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

-- | The laying of a drawing, without the cells above and left of the array. Refuses a drawing that
-- takes such cells.
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
