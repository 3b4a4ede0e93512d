-- | The paper's array: x^4 + x^2 + A x + A^2 over GF(4), 15 x 17 cells along the diagonal, with
-- windows of 2 x 2 cells.
module Test.Paper
  ( paperPrimitive,
    paperArray,
    paperOn,
    paperShape,
    paperWindow,
    paperTable,
    paperCodebook,
    paperAlgebra,
    everywhere,

    -- * An array of 2^60 cells
    vastArray,
    vastAlgebra,

    -- * The parts of an array
    Cells,
    look,
  )
where

import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate (Table, buildTable)
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Polynomial
import PraTactile.Window
import Test.Code.Generators

paperPrimitive :: IO (Primitive GF4)
paperPrimitive = right (checkPrimitive (polynomial [a * a, a, 1, 0, 1]))
  where
    a = primitive

paperOn :: Surface -> IO (ArrayOn GF4)
paperOn surface = ArrayOn surface <$> paperArray

paperShape :: Shape
paperShape = Shape 15 17

paperArray :: IO (PseudorandomArray GF4)
paperArray = paperPrimitive >>= right . folded Diagonal paperShape

paperWindow :: IO Mask
paperWindow = right (rectangle (Shape 2 2))

paperTable :: Surface -> IO (Table GF4)
paperTable = onPaper (buildTable MostSignificantFirst)

paperCodebook :: Surface -> IO (Codebook GF4)
paperCodebook = onPaper buildCodebook

paperAlgebra :: Surface -> IO (Algebra GF4)
paperAlgebra = onPaper prepareAlgebra

onPaper :: Show e => (ArrayOn GF4 -> Mask -> Either e a) -> Surface -> IO a
onPaper make surface = make <$> paperOn surface <*> paperWindow >>= right

-- | The 255 positions of the paper's array.
everywhere :: [Position]
everywhere = cellsOf paperShape

-- | The first array over GF(4) for windows of 15 x 2 cells.
vastArray :: IO (PseudorandomArray GF4)
vastArray = arrayOver gf4 30 Diagonal (Shape (4 ^ (15 :: Int) - 1) (4 ^ (15 :: Int) + 1))

vastAlgebra :: IO (Algebra GF4)
vastAlgebra = prepareAlgebra . naturally <$> vastArray <*> right (rectangle (Shape 15 2)) >>= right

type Cells = [[Maybe (GF GF4)]]

-- | The cells of an array in a rectangle of this shape at this position.
look :: KnownField k => PseudorandomArray k -> Shape -> Position -> [[Maybe (GF k)]]
look array shape@(Shape _ w) (Position r c) =
  rowsOf w [Just (cellAt array (Position (r + i) (c + j))) | Position i j <- cellsOf shape]
