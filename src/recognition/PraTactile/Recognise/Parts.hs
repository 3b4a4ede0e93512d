{-# OPTIONS_HADDOCK hide #-}

-- | Reads parts of symbols: in cells beside the symbols that were cut out, as far as the composite
-- shows them.
module PraTactile.Recognise.Parts
  ( withParts,
  )
where

import Data.Bifunctor (first)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Vector.Storable as V
import PraTactile.Classification.Estimate
import PraTactile.Classification.Part
import PraTactile.Classification.Reader (Reader (..))
import PraTactile.Geometry (columnPitch, rowPitch, symbolHeight, symbolWidth)
import PraTactile.Image (rasterValues)
import PraTactile.Recognise.FaceGrid
import PraTactile.Recognise.Reading
import PraTactile.Registration (Composite (..))
import PraTactile.Segmentation
import PraTactile.Segmentation.Lattice (ClusterCell)
import PraTactile.Symmetry

-- | Adds to a grid the parts of symbols that each composite shows in cells around its own symbols.
-- Returns the larger grid and the parts. Arguments: the reader; the views of the composites; the
-- number of the first part; the grid.
withParts :: Reader -> [SymbolView] -> Int -> FaceGrid -> (FaceGrid, [ReadSymbol])
withParts reader views from grid =
  ( grid
      { gridCells = fromZero all',
        gridAnchor = (left + columnPitch * fromIntegral j, top + rowPitch * fromIntegral i)
      },
    map snd found
  )
  where
    all' = Map.unionWith (++) (gridCells grid) cells
    (i, j) = firstOf all'
    (left, top) = gridAnchor grid
    found =
      zipWith
        (\n (cell, part) -> (cell, part {readNumber = n}))
        [from ..]
        (concatMap (partsOf reader (gridCells grid)) views)
    cells = Map.fromListWith (++) [(cell, [part]) | (cell, part) <- found]

-- | The parts in one composite for which one symbol is more likely than all others together, each
-- with its cell of the grid.
partsOf :: Reader -> Cells -> SymbolView -> [(ClusterCell, ReadSymbol)]
partsOf reader cells view =
  [ (cell, part)
    | (cell, centres) <- Map.toList expected,
      let at = centroid centres,
      Just seen <- [look (onView view at)],
      let part = readPart view at seen (estimatePart (readerTemplates reader) sigma seen),
      readDoubt part < 0.5
  ]
  where
    sigma = compositeUnregisteredError (viewComposite view)
    look = partAt (viewComposite view) (segmentedBackground found, segmentedContrast found) 0
    found = viewSegmentation view
    own = [(cell, s) | (cell, here) <- Map.toList cells, s <- here, readSource s == viewSource view]
    taken = Set.fromList (map fst own)
    -- The centre of each free cell, as each symbol around it implies it.
    expected =
      Map.fromListWith
        (++)
        [ (cell, [(x + dx, y + dy)])
          | ((i, j), s) <- own,
            di <- [-1, 0, 1],
            dj <- [-1, 0, 1],
            let cell = (i + di, j + dj),
            cell `Set.notMember` taken,
            let (x, y) = readAt s,
            let (dx, dy) =
                  onOffset
                    (viewAxis view)
                    (columnPitch * fromIntegral dj, rowPitch * fromIntegral di)
        ]

-- | A part as a symbol that was read, with the number 0. Arguments: the view; the place of its
-- centre on the first composite's grid; the part; its estimate.
readPart :: SymbolView -> (Double, Double) -> Part -> ClassEstimate -> ReadSymbol
readPart view (x, y) seen estimated =
  ReadSymbol
    { readNumber = 0,
      readSource = viewSource view,
      readImage =
        SymbolImage
          { symbolCentre = (x - fst (viewShift view), y - snd (viewShift view)),
            symbolPixels = partPixels seen,
            symbolAxis = degreesClockwise (viewAxis view),
            symbolSize = (fromIntegral symbolWidth, fromIntegral symbolHeight)
          },
      readAt = (x, y),
      readClass = Nothing,
      readSeen = V.sum (rasterValues (partSeen seen)) / fromIntegral (symbolWidth * symbolHeight),
      readLikeliest = alongAxis (viewAxis view) (estimateLikeliest estimated),
      readChances = map (first (alongAxis (viewAxis view))) (estimateChances estimated),
      -- Parts are not compared with other shapes.
      readForeignShape = estimateForeignShape estimated
    }
