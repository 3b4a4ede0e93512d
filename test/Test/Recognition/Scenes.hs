{-# LANGUAGE RankNTypes #-}

-- | Grids of symbols that the paper's array has somewhere, damaged, as recognition reads them.
module Test.Recognition.Scenes
  ( Scene (..),
    genScene,
    scattered,
    OnArray,
    cellOf,
    onRecognisers,
  )
where

import qualified Data.Map.Strict as Map
import PraTactile.Array
import PraTactile.Field (KnownField, toCode)
import PraTactile.Recognise
import PraTactile.Recognise.FaceGrid
import PraTactile.Symmetry
import Test.Hspec
import Test.QuickCheck hiding (tolerance)
import Test.Recognition.Setting
import Test.Recognition.Symbols

-- | Tests of the shipped recogniser on the torus and on the sheet, given the array.
onRecognisers ::
  (forall k. KnownField k => PseudorandomArray k -> [(Surface, Recogniser k)] -> Spec) -> Spec
onRecognisers tests = onPaper $ \setting ->
  tests (settingArray setting) [(on, recogniserOn on setting) | on <- [Torus, Sheet]]

-- | A grid of symbols that the array has from a position on, seen in an orientation, with damage:
-- some cells have none, some two.
data Scene = Scene
  { sceneOrientation :: Symmetry,
    scenePosition :: Position,
    -- | as they lie on the face
    sceneCells :: Cells
  }

-- | The place and the symbol of an array in a cell of a grid whose first cell is at a position;
-- 'Nothing' beyond the sheet.
type OnArray = Position -> (Int, Int) -> Maybe (Position, Int)

-- | The place and the symbol of the paper's array.
cellOf :: KnownField k => Surface -> PseudorandomArray k -> OnArray
cellOf surface array (Position r c) (i, j)
  | surface == Torus || inside = Just (place, toCode (cellAt array place))
  | otherwise = Nothing
  where
    (down, across) = (fromIntegral r + i, fromIntegral c + j)
    inside = down >= 0 && down < 15 && across >= 0 && across < 17
    place = Position (fromIntegral (down `mod` 15)) (fromIntegral (across `mod` 17))

-- | A scene, given the symbol in each of its cells and the doubts of its symbols.
genScene :: OnArray -> [Double] -> Gen Scene
genScene cell doubts = do
  orientation <- elements rotations
  position <- Position <$> elements [0 .. 14] <*> elements [0 .. 16]
  (high, wide) <- elements [(1, 1), (2, 2), (2, 3), (3, 3), (1, 5), (3, 4)]
  wrong <- frequency [(3, pure 0), (2, choose (0, 0.4))]
  gaps <- frequency [(3, pure 0), (1, choose (0, 0.7))]
  unknown <- frequency [(5, pure (1 / 6)), (1, pure 1)]
  let cells = [(i, j) | i <- [0 .. high - 1], j <- [0 .. wide - 1]] :: [(Int, Int)]
  here <- traverse (symbolsIn orientation position (wrong, unknown) gaps) cells
  let drawn = concat (zipWith (\at -> map ((,) at)) cells here)
      numbered = zipWith (\n (at, s) -> (at, [s {readNumber = n}])) [0 ..] drawn
  pure (Scene orientation position (Map.fromListWith (flip (++)) numbered))
  where
    symbolsIn orientation position wrong gaps at = do
      empty <- chance gaps
      count <- if empty then pure 0 else frequency [(6, pure 1), (1, pure 2)]
      vectorOf count (symbolIn orientation position wrong at)
    symbolIn orientation position (wrong, unknown) (i, j) = do
      spoilt <- chance wrong
      about <- chance (wrong / 3)
      other <- choose (0, 3)
      doubt <- elements doubts
      known <- not <$> chance unknown
      source <- choose (0, 2)
      seen <- frequency [(8, pure 1), (1, pure (1 / 3)), (1, pure 0.3)]
      jitter <- (,) <$> choose (-1, 1) <*> choose (-1, 1)
      let true = maybe other snd (cell position (i, j))
          class' = if spoilt then other else true
          way = if about then orientation <> turned 2 else orientation
          rest = [(o, c) | o <- [way, way <> turned 2], c <- [0 .. 3], (o, c) /= (way, class')]
          (x, y) = onOffset orientation (16 * fromIntegral j, 20 * fromIntegral i)
      pure
        (symbolOf 0 (x + fst jitter + 50, y + snd jitter - 9) (way, class'))
          { readSource = source,
            readClass = if known && seen == 1 then Just (way, class') else Nothing,
            readSeen = seen,
            readChances = ((way, class'), 1 - doubt) : [(what, doubt / 7) | what <- rest]
          }
    chance p = (< p) <$> choose (0, 1 :: Double)

-- | A scene's cells along the axes of its symbols, as recognition finds them.
scattered :: Scene -> Cells
scattered scene
  | quarterTurns (sceneOrientation scene) >= 2 = Map.mapKeys about cells
  | otherwise = cells
  where
    cells = sceneCells scene
    about (i, j) = (furthest fst - i, furthest snd - j)
    furthest part = maximum (0 : map part (Map.keys cells))
