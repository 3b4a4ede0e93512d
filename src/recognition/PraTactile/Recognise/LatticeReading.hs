{-# OPTIONS_HADDOCK hide #-}

-- | Reads the symbols in the cells of the lattice that registration found under a composite.
--
-- All frames together determine which symbol a cell holds ('latticeCells'). The network also reads
-- complete symbols from the composite, as in the paper; a symbol that it does not know is no
-- witness.
module PraTactile.Recognise.LatticeReading
  ( CellsRead (..),
    latticesRead,
    readCells,
    numberCells,
    cellsGroup,
    axisOfAll,
    cellsMirrored,
  )
where

import Data.Bifunctor (first)
import Data.List (foldl', mapAccumL)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Storable as V
import qualified Data.Vector.Unboxed as Unboxed
import PraTactile.Classification.Estimate
import PraTactile.Classification.Network (NetworkError)
import PraTactile.Classification.Part (estimatePart)
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Composite (compositeFrom)
import PraTactile.Composite.Blend (Taxels, minus, plus)
import PraTactile.Composite.Lattice
import PraTactile.Geometry
import PraTactile.Image (constant, onRaster, rasterValues)
import PraTactile.Recognise.Reading
import PraTactile.Registration (Composite)
import PraTactile.Registration.Model (classPrior)
import PraTactile.Registration.Numbers (absence)
import PraTactile.Segmentation
import PraTactile.Segmentation.Lattice (ClusterCell)
import PraTactile.Symmetry

-- | The symbols in the cells of one composite.
data CellsRead = CellsRead
  { -- | Their axis, up to 180 degrees: 'identity' or @turned 1@.
    cellsAxis :: !Symmetry,
    -- | Their angle beyond that axis, in degrees clockwise.
    cellsSkew :: !Double,
    -- | The centre of cell (0, 0) on the first composite's grid of pixels.
    cellsFirst :: !Taxels,
    -- | The symbols by row and column, counted along their axis.
    cellsSymbols :: !(Map ClusterCell ReadSymbol)
  }

-- | The axis of the symbols on the first lattice, and their angle beyond it in degrees clockwise.
-- 'identity' and 0 without a lattice.
axisOfAll :: [Lattice] -> (Symmetry, Double)
axisOfAll lattices = case map (axisAlong 0) lattices of
  (axis, skew, _) : _ -> (axis, skew)
  [] -> (identity, 0)

-- | The symbols that the frames imply in the cells of each composite's lattice. The composites are
-- of one face; places are on the first composite's grid.
latticesRead :: [(Composite, Lattice)] -> [CellsRead]
latticesRead given =
  [ cellsOf skew source (compositeFrom composite, base) lattice
    | (source, (composite, lattice)) <- zip [0 ..] given
  ]
  where
    (_, skew) = axisOfAll (map snd given)
    base = case given of
      (composite, _) : _ -> compositeFrom composite
      [] -> (0, 0)

-- | The axis of a lattice relative to an angle in degrees: the symbols' axis, the lattice's angle
-- beyond it, and whether the lattice's axes point opposite to the symbols'.
axisAlong :: Double -> Lattice -> (Symmetry, Double, Bool)
axisAlong skew lattice =
  (if odd quarters then turned 1 else identity, beyond, odd (quarters `div` 2))
  where
    quarters :: Int
    quarters = floor ((latticeAngle lattice - skew + 45) / 90)
    beyond = latticeAngle lattice - 90 * fromIntegral quarters

-- | The symbols of a lattice by its frames, without their images: the cells in which one symbol is
-- more likely than all others together. Arguments: the angle of the first composite's symbols; the
-- composite's number; pixel (0, 0) of the composite and of the first composite, in taxels from the
-- robot's origin; the lattice. Symbols count as complete, and as known if their doubt is below 0.1.
cellsOf :: Double -> Int -> (Taxels, Taxels) -> Lattice -> CellsRead
cellsOf skew source (own, base) lattice =
  CellsRead
    { cellsAxis = axis,
      cellsSkew = beyond,
      cellsFirst = centreOf (0, 0) `minus` base,
      cellsSymbols =
        Map.filter ((< 0.5) . readDoubt) . Map.fromList $
          [(along cell, symbol (centreOf cell) logs) | (cell, logs) <- Map.toList cells]
    }
  where
    (axis, beyond, against) = axisAlong skew lattice
    way = if latticeHalfTurned lattice /= against then turned 2 else identity
    cells = latticeCells lattice
    along (i, j) = if against then (negate i, negate j) else (i, j)
    centreOf :: ClusterCell -> Taxels
    centreOf cell =
      latticeOrigin lattice
        `plus` latticeStep lattice cell
        `plus` rotated (latticeAngle lattice) (fromCorner symbolWidth, fromCorner symbolHeight)
    fromCorner side = (fromIntegral side - 1) / 2
    symbol centre logs
      | readDoubt told < 0.1 = told {readClass = Just (readLikeliest told)}
      | otherwise = told
      where
        told =
          estimatedAs axis (estimateOf way logs) $
            ReadSymbol
              { readNumber = 0,
                readSource = source,
                readImage =
                  SymbolImage
                    { symbolCentre = centre `minus` own,
                      symbolPixels = constant symbolWidth symbolHeight 0,
                      symbolAxis = degreesClockwise axis + beyond,
                      symbolSize = (fromIntegral symbolWidth, fromIntegral symbolHeight)
                    },
                readAt = centre `minus` base,
                readClass = Nothing,
                readSeen = 1,
                readLikeliest = (axis, 0),
                readChances = [],
                readForeignShape = 0
              }

-- | A symbol with the orientations and classes of an estimate along an axis.
estimatedAs :: Symmetry -> ClassEstimate -> ReadSymbol -> ReadSymbol
estimatedAs axis estimated s =
  s
    { readLikeliest = alongAxis axis (estimateLikeliest estimated),
      readChances = map (first (alongAxis axis)) (estimateChances estimated)
    }

-- | Adds to the cells what the composite's images show. Arguments: the reader; the composite, and
-- its masked images; its lattice; its cells as the frames imply them.
--
-- A complete symbol gets the network's class; any other symbol becomes a part. If a foreign thing
-- covers some of a symbol, the symbol is estimated from the rest. Symbols with a doubt of one half
-- or more are dropped. Refuses what the network refuses.
readCells ::
  Reader -> (Composite, ForeignMasked) -> Lattice -> CellsRead -> Either NetworkError CellsRead
readCells reader (composite, ForeignMasked clean byHeight foreignThings) lattice found = do
  symbols <- Map.traverseMaybeWithKey (const inImage) (cellsSymbols found)
  pure found {cellsSymbols = Map.filter ((< 0.5) . readDoubt) symbols}
  where
    axis = cellsAxis found
    cutFrom image =
      partAt
        image
        (latticeFlat lattice, latticeContrast lattice)
        (degreesClockwise axis + cellsSkew found)
    cutWhole = cutFrom clean
    cutPart = maybe cutWhole cutFrom byHeight
    cutAll = cutFrom composite
    taxelsOf = V.sum . rasterValues . partSeen
    isWhole part = taxelsOf part >= leastTouched
    inImage s = case cutWhole centre of
      Just whole | isWhole whole -> Just . told whole <$> network whole
      _ -> pure (asPart <$> cutPart centre)
      where
        centre = symbolCentre (readImage s)
        network whole = do
          seen <- readSymbol reader axis (readSource s) (0, 0) (imageOf whole)
          pure
            s
              { readImage = imageOf whole,
                readClass = readClass seen,
                readForeignShape = readForeignShape seen
              }
        asPart part =
          told
            part
            s
              { readImage = imageOf part,
                readClass = Nothing,
                readSeen = taxelsOf part / fromIntegral (symbolWidth * symbolHeight)
              }
        imageOf part = (readImage s) {symbolPixels = partPixels part}
        told part
          | spoilt part = estimatedAs axis (estimatePart (readerTemplates reader) 0 part)
          | otherwise = id
        spoilt part =
          not (null foreignThings)
            && maybe False ((> taxelsOf part) . taxelsOf) (cutAll centre)

-- | Numbers the symbols: complete ones from 0, then parts.
numberCells :: [CellsRead] -> [CellsRead]
numberCells = snd . numbered (< 1) . numbered (>= 1) . (,) 0
  where
    numbered which (from, found) = mapAccumL (inCells which) from found
    inCells which from cells =
      (\symbols -> cells {cellsSymbols = symbols})
        <$> mapAccumL (number which) from (cellsSymbols cells)
    number :: (Double -> Bool) -> Int -> ReadSymbol -> (Int, ReadSymbol)
    number which n s
      | which (readSeen s) = (n + 1, s {readNumber = n})
      | otherwise = (n, s)

-- | The posterior of the symbol in a cell, by the log-likelihood ratios of its classes to an empty
-- cell. The way up is given. An empty cell may be of any class.
estimateOf :: Symmetry -> ClassLogs -> ClassEstimate
estimateOf way logs = ClassEstimate (likeliest, way) chances 0
  where
    q = Unboxed.length logs
    top = max 0 (Unboxed.maximum logs)
    weights = Unboxed.map (\l -> classPrior q * exp (l - top)) logs
    empty = absence * exp (negate top)
    total = empty + Unboxed.sum weights
    posterior k = (weights Unboxed.! k + empty / fromIntegral q) / total
    likeliest = foldl' (\a b -> if logs Unboxed.! b > logs Unboxed.! a then b else a) 0 [0 .. q - 1]
    -- All other classes and ways up together keep at least the probability 'leastDoubt'.
    chances =
      [ ((k, way'), floored (if way' == way then posterior k else 0))
        | way' <- [identity, turned 2],
          k <- [0 .. q - 1]
      ]
    floored p = (1 - spread) * p + spread / n
    spread = leastDoubt * n / (n - 1)
    n = 2 * fromIntegral q

-- | The symbols of a composite as one group, with places along axes at this angle.
cellsGroup :: Double -> CellsRead -> Group
cellsGroup angle found =
  Group
    { groupCells = Just (cellsSymbols found),
      groupAnchor = rotated (negate angle) (cellsFirst found),
      groupSymbols = Map.elems (cellsSymbols found)
    }

-- | Whether the network knows most of these complete symbols in their mirror images. Refuses what
-- the network refuses.
cellsMirrored :: Reader -> [ReadSymbol] -> Either NetworkError Bool
cellsMirrored reader symbols =
  mostRecognised <$> traverse (readSymbol reader identity 0 (0, 0) . mirroredImage) symbols
  where
    mirroredImage s =
      let image = readImage s in image {symbolPixels = onRaster mirror (symbolPixels image)}
