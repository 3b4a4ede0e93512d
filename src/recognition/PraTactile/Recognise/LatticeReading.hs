{-# OPTIONS_HADDOCK hide #-}

-- | Reading the symbols in the cells of the lattice that registration found under a composite.
--
-- Which symbol a cell holds is told by all the frames ('latticeCells'). The network reads complete
-- symbols beside that, from the composite, as in the paper: what it does not know is no witness.
module PraTactile.Recognise.LatticeReading
  ( CellsRead (..),
    readCells,
    cellsGroup,
    alongTilt,
    cellsMirrored,
  )
where

import Data.Bifunctor (first)
import Data.List (foldl')
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Classification.Estimate
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Classification.Part (estimatePart)
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Composite.Blend (Taxels, plus)
import PraTactile.Composite.Lattice
import PraTactile.Geometry
import PraTactile.Image (onRaster, rasterValues)
import PraTactile.Recognise.Reading
import PraTactile.Registration (Composite (..))
import PraTactile.Registration.Model (absence, classPrior)
import PraTactile.Segmentation
import PraTactile.Segmentation.Lattice (Cell)
import PraTactile.Symmetry

-- | What the cells of a composite show.
data CellsRead = CellsRead
  { -- | How the symbols are turned, up to 180 degrees: 'identity' or @turned 1@.
    cellsAxis :: !Symmetry,
    -- | By how many degrees, clockwise, they are turned beside that.
    cellsTilt :: !Double,
    -- | The centre of cell (0, 0) on the first composite's grid of pixels.
    cellsFirst :: !Taxels,
    -- | Complete symbols, by row and column along their axis.
    cellsWhole :: !(Map Cell ReadSymbol),
    -- | Parts of symbols, likewise.
    cellsParts :: !(Map Cell ReadSymbol)
  }

-- | How the axes of a lattice lie beside a tilt, in degrees: the axis of the symbols, what is left
-- of the tilt, and whether the lattice's axes point against theirs.
alongTilt :: Double -> Lattice -> (Symmetry, Double, Bool)
alongTilt tilt lattice =
  (if odd quarters then turned 1 else identity, beyond, quarters `mod` 4 >= 2)
  where
    quarters = floor ((latticeAngle lattice - tilt + 45) / 90) :: Int
    beyond = latticeAngle lattice - 90 * fromIntegral quarters

-- | The symbols in the cells of the composite with this number, given the tilt that those of the
-- first composite have, where its pixel (0, 0) is on the first one's grid, and the composite
-- without what is foreign. Refuses what the network refuses.
readCells ::
  Reader ->
  Double ->
  Int ->
  Taxels ->
  (Composite, Cleaned) ->
  Lattice ->
  Either NetworkError CellsRead
readCells reader tilt source shift (composite, Cleaned clean forParts foreignThings) lattice = do
  found <- traverse (uncurry readCell) (Map.fromList (concatMap seenIn cells))
  let (whole, parts) = Map.partition ((>= 1) . readSeen) (Map.filter ((< 0.5) . readDoubt) found)
  pure
    CellsRead
      { cellsAxis = axis,
        cellsTilt = beyond,
        cellsFirst = centreOf (0, 0) `plus` shift,
        cellsWhole = whole,
        cellsParts = parts
      }
  where
    (axis, beyond, against) = alongTilt tilt lattice
    way = if latticeHalfTurned lattice /= against then turned 2 else identity
    angle = degreesClockwise axis + beyond
    cells = Map.toList (latticeCells lattice)
    along (i, j) = if against then (negate i, negate j) else (i, j)
    centreOf (i, j) =
      latticeOrigin lattice
        `plus` rotated
          (latticeAngle lattice)
          ( columnPitch * fromIntegral j + (fromIntegral symbolWidth - 1) / 2,
            rowPitch * fromIntegral i + (fromIntegral symbolHeight - 1) / 2
          )
    cutFrom image =
      partAt image (latticeFlat lattice, latticeContrast lattice) angle
    cutWhole = cutFrom clean
    cutPart = maybe cutWhole cutFrom forParts
    cutAll = cutFrom composite
    -- What of each cell was seen, and of which no foreign thing takes a part its classes.
    seenIn (cell, logs) =
      [ (along cell, (centre, if spoilt then Left part else Right (logs, part)))
        | let centre = centreOf cell,
          Just part <- [wholeOr (cutWhole centre) (cutPart centre)],
          let spoilt =
                not (null foreignThings)
                  && maybe False ((> taxelsOf part) . taxelsOf) (cutAll centre)
      ]
    wholeOr whole part = case whole of
      Just it | isWhole it -> whole
      _ -> part
    taxelsOf = V.sum . rasterValues . partSeen
    isWhole part = taxelsOf part >= leastTouched
    readCell centre seen = case seen of
      Left part -> byItself part (estimatePart (readerTemplates reader) 0 part)
      Right (logs, part) -> byItself part (estimateOf way logs)
      where
        byItself part estimated
          | isWhole part = told estimated <$> readSymbol reader axis source shift (imageOf part)
          | otherwise =
            pure . told estimated $
              ReadSymbol
                { readNumber = 0,
                  readSource = source,
                  readImage = imageOf part,
                  readAt = centre `plus` shift,
                  readClass = Nothing,
                  readSeen = taxelsOf part / fromIntegral (symbolWidth * symbolHeight),
                  readLikeliest = (axis, 0),
                  readChances = [],
                  readUnlike = 0
                }
        imageOf part =
          SymbolImage
            { symbolCentre = centre,
              symbolPixels = partPixels part,
              symbolAxis = angle,
              symbolSize = (fromIntegral symbolWidth, fromIntegral symbolHeight)
            }
    told estimated s =
      s
        { readLikeliest = alongAxis axis (estimateLikeliest estimated),
          readChances = map (first (alongAxis axis)) (estimateChances estimated)
        }

-- | The posterior of the symbol in a cell, which stands this way up, by what the frames show of its
-- classes. An empty cell may be of any class.
estimateOf :: Symmetry -> ClassLogs -> Estimate
estimateOf way logs = Estimate (likeliest, way) chances 0
  where
    q = Unboxed.length logs
    top = max 0 (Unboxed.maximum logs)
    weights = Unboxed.map (\l -> classPrior q * exp (l - top)) logs
    empty = absence * exp (negate top)
    total = empty + Unboxed.sum weights
    posterior k = (weights Unboxed.! k + empty / fromIntegral q) / total
    likeliest = foldl' (\a b -> if logs Unboxed.! b > logs Unboxed.! a then b else a) 0 [0 .. q - 1]
    -- Every other class and way up together has the least doubt.
    chances =
      [ ((k, way'), floored (if way' == way then posterior k else 0))
        | way' <- [identity, turned 2],
          k <- [0 .. q - 1]
      ]
    floored p = (1 - spread) * p + spread / n
    spread = leastDoubt * n / (n - 1)
    n = 2 * fromIntegral q

-- | The symbols and parts of a composite as one group, whose places are along axes at this angle.
cellsGroup :: Double -> CellsRead -> Group
cellsGroup angle found =
  Group
    { groupCells = Just cells,
      groupAnchor = rotated (negate angle) (cellsFirst found),
      groupSymbols = Map.elems cells
    }
  where
    cells = Map.union (cellsWhole found) (cellsParts found)

-- | Whether the network knows most of some complete symbols mirrored.
cellsMirrored :: Reader -> [ReadSymbol] -> Either NetworkError Bool
cellsMirrored reader symbols =
  mostRecognised <$> traverse (readSymbol reader identity 0 (0, 0) . mirroredImage) symbols
  where
    mirroredImage s =
      let image = readImage s in image {symbolPixels = onRaster mirror (symbolPixels image)}
