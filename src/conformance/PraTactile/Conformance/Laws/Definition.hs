-- | What locating is held against: the definition, by comparing all windows of the array, whose
-- cells the implementation itself is asked for. And the patches drawn for it: a place, a shape,
-- cells not observed and wrong ones.
module PraTactile.Conformance.Laws.Definition
  ( -- * The array
    Looked,
    onTorus,
    lookedAt,
    contentsAt,
    leastDistance,
    radiusOf,

    -- * Patches
    Seen (..),
    patchOf,
    observedOf,
    Damage (..),
    undamaged,
    genSeen,
    shapesAround,
    forSeen,
  )
where

import Control.Monad.Trans.Except (runExceptT)
import Data.List (foldl', tails)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Vector.Unboxed (Vector)
import qualified Data.Vector.Unboxed as Vector
import Numeric.Natural (Natural)
import PraTactile.Array
  ( Position (..),
    Shape (..),
    Surface (..),
    area,
    naturalSurface,
    naturalsBelow,
    shapeCells,
  )
import PraTactile.Conformance.Implementation
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | All cells of an array, row by row, with its profile.
data Looked = Looked
  { lookedProfile :: Profile,
    lookedCells :: Vector Int
  }

-- | Look at all cells first. Arrays of more than 1024 cells, of which all windows are not compared,
-- satisfy every law that needs it.
lookedAt :: Session -> (Looked -> Property) -> Property
lookedAt s property'
  | area shape > 1024 = label "not compared: more than 1024 cells" True
  | otherwise = idempotentIOProperty $ do
    cells <- runExceptT (traverse (cell s) (shapeCells shape))
    pure $ case cells of
      Left found -> counterexample ("a cell of the array was refused: " ++ show found) False
      Right found -> property' (Looked (profile s) (Vector.fromList (map fromIntegral found)))
  where
    shape = profileShape (profile s)

-- | As if it lay on the torus.
onTorus :: Looked -> Looked
onTorus looked = looked {lookedProfile = (lookedProfile looked) {profileSurface = Torus}}

-- | The contents of cells, by their offsets, at every position of a surface at which all of them
-- lie on it.
contentsAt :: Surface -> Looked -> [Position] -> [(Position, [Int])]
contentsAt surface looked offsets =
  [ (Position (fromIntegral r) (fromIntegral c), content)
    | r <- [0 .. n1 - 1],
      c <- [0 .. n2 - 1],
      Just content <- [traverse ((\(i, j) -> at (r + i) (c + j)) . ints) offsets]
  ]
  where
    Shape high wide = profileShape (lookedProfile looked)
    n1 = fromIntegral high :: Int
    n2 = fromIntegral wide :: Int
    ints (Position i j) = (fromIntegral i, fromIntegral j)
    at r c = case surface of
      Torus -> looking (r `mod` n1) (c `mod` n2)
      TwistedTorus -> looking ((r + c `div` n2) `mod` n1) (c `mod` n2)
      Sheet
        | r < n1 && c < n2 -> looking r c
        | otherwise -> Nothing
    looking r c = lookedCells looked Vector.!? (r * n2 + c)

-- | The least number of cells in which two contents differ on the array's own surface; 0 if the
-- profile's surface is neither that nor the sheet, and for no cells.
leastDistance :: Looked -> [Position] -> Natural
leastDistance looked offsets
  | profileSurface p `notElem` [Sheet, own] || null offsets = 0
  | otherwise =
    fromIntegral
      (foldl' nearer (length offsets) [(a, b) | a : others <- tails contents, b <- others])
  where
    p = lookedProfile looked
    own = naturalSurface (profileFolding p)
    contents = map snd (contentsAt own looked offsets)
    nearer best (a, b) = counted 0 a b
      where
        -- Counts no further than to the best one so far.
        counted n (x : xs) (y : ys)
          | n >= best = best
          | otherwise = counted (if x == y then n else n + 1) xs ys
        counted n _ _ = min best (n :: Int)

-- | The largest e with 2 e < d; 0 for d = 0.
radiusOf :: Natural -> Natural
radiusOf d = if d == 0 then 0 else (d - 1) `div` 2

-- | A patch: where its upper left cell is, its shape, the cells not observed, and wrong ones, with
-- what is added to their codes modulo q.
data Seen = Seen
  { seenPlace :: Position,
    seenShape :: Shape,
    seenGone :: [Position],
    seenWrong :: [(Position, Natural)]
  }
  deriving stock (Show)

-- | The rows as they are seen.
patchOf :: Looked -> Seen -> [[Maybe Code]]
patchOf looked seen =
  [ [ if cell' `elem` seenGone seen then Nothing else changed cell' <$> Map.lookup cell' content
      | j <- naturalsBelow w,
        let cell' = Position i j
    ]
    | i <- naturalsBelow h
  ]
  where
    Shape h w = seenShape seen
    content = originalOf looked seen
    changed cell' code =
      maybe
        code
        (\by -> (code + by) `mod` profileOrder (lookedProfile looked))
        (lookup cell' (seenWrong seen))

-- | The cells as they are in the array.
originalOf :: Looked -> Seen -> Map Position Code
originalOf looked seen =
  Map.fromList
    ( concat
        [ zip offsets (map fromIntegral content)
          | (place, content) <- contentsAt surface looked offsets,
            place == seenPlace seen
        ]
    )
  where
    Shape h w = seenShape seen
    offsets = shapeCells (Shape h w)
    surface = profileSurface (lookedProfile looked)

-- | The offsets and codes of the observed cells.
observedOf :: [[Maybe Code]] -> [(Position, Code)]
observedOf cells =
  [(Position i j, code) | (i, line) <- zip [0 ..] cells, (j, Just code) <- zip [0 ..] line]

-- | Shapes from a single row to two rows and columns more than the window, of at most 16 cells,
-- that fit on the sheet.
shapesAround :: Profile -> [Shape]
shapesAround p = filter fits [Shape h' w' | h' <- [1 .. h + 2], w' <- [1 .. w + 2], h' * w' <= 16]
  where
    Shape h w = profileWindow p
    fits shape = rows shape <= rows (profileShape p) && columns shape <= columns (profileShape p)

-- | How many per cent of the cells are not observed, and how many per cent of the others wrong.
data Damage = Damage Int Int

-- | None.
undamaged :: Damage
undamaged = Damage 0 0

-- | A patch of one of these shapes on the profile's surface, damaged.
genSeen :: Profile -> [Shape] -> Damage -> Gen Seen
genSeen p shapes (Damage erased wrong) = do
  shape@(Shape h w) <- elements shapes
  let Shape n1 n2 = profileShape p
      last' n size = if profileSurface p == Sheet then n - size else n - 1
  place <- Position <$> upTo (last' n1 h) <*> upTo (last' n2 w)
  fates <-
    vectorOf
      (fromIntegral (h * w))
      ((,,) <$> choose (1, 100) <*> choose (1, 100) <*> upTo (profileOrder p - 2))
  let cells = zip (shapeCells (Shape h w)) fates
  pure
    ( Seen
        place
        shape
        [cell' | (cell', (a, _, _)) <- cells, a <= erased]
        [(cell', 1 + by) | (cell', (a, b, by)) <- cells, a > erased, b <= wrong]
    )
  where
    upTo n = fromInteger <$> chooseInteger (0, toInteger n)

-- | For patches drawn so, shrunk by undoing their damage.
forSeen :: Gen Seen -> (Seen -> Property) -> Property
forSeen gen = forAllShrink gen $ \seen ->
  [seen {seenWrong = fewer} | fewer <- without (seenWrong seen)]
    ++ [seen {seenGone = fewer} | fewer <- without (seenGone seen)]
  where
    without xs = [take i xs ++ drop (i + 1) xs | i <- [0 .. length xs - 1]]
