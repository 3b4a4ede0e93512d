-- | What the memory table answers about any patch, by comparing every cell at every place.
module Test.Code.Locate.Reasons (genPatch, shrinkPatch, asByComparing, locateRows) where

import Data.List (nub)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import Test.Code.Generators
import Test.Code.Locate.Scenes (genPosition)
import Test.Paper
import Test.QuickCheck hiding (elements)

locateRows :: Table k -> [[Maybe (GF k)]] -> Either LocateError (Outcome Position)
locateRows table cells = locatePatch table <$> patch cells

-- | A patch of the array with unobserved cells, often with an error, sometimes across the edges.
genPatch :: PseudorandomArray GF4 -> Gen Cells
genPatch array = do
  size <- Shape <$> side <*> side
  from <- genPosition paperShape
  errors <- frequency [(3, pure 0), (2, pure 8), (1, pure 60)] :: Gen Int
  unobserved <- oneof (map pure [0, 10, 30, 60]) :: Gen Int
  let observe a = do
        wrong <- (< errors) <$> choose (0, 99)
        gone <- (< unobserved) <$> choose (0, 99)
        b <- if wrong then Just <$> genElement else pure a
        pure (if gone then Nothing else b)
  mapM (mapM observe) (look array size from)
  where
    side = fromInteger <$> choose (1, 5)

-- | Fewer rows, fewer columns, fewer observed cells.
shrinkPatch :: Cells -> [Cells]
shrinkPatch cells =
  [ fewer
    | fewer <-
        [ drop 1 cells,
          take (length cells - 1) cells,
          map (drop 1) cells,
          map (\r -> take (length r - 1) r) cells
        ],
      not (all null fewer)
  ]
    ++ [ [ [if (i, j) == (i0, j0) then Nothing else a | (j, a) <- zip [0 ..] r]
           | (i, r) <- zip [0 :: Int ..] cells
         ]
         | (i0, r0) <- zip [0 ..] cells,
           (j0, Just _) <- zip [0 :: Int ..] r0
       ]

-- | Compare every observed cell at every place; then the outcome must be what this says. On the
-- sheet, places beyond its edges are tried, too: the patch sticks out where all that lies on the
-- sheet agrees, every window that stands on the sheet among it.
asByComparing :: PseudorandomArray GF4 -> Surface -> Table GF4 -> Cells -> Property
asByComparing array on table cells =
  counterexample (show (outcome, fitting)) $ case outcome of
    Right (Unique p support) -> fitting === [p] .&&. support === offsets
    Right (Refused TooFewCells) -> property (null observed)
    Right (Refused NoCompleteWindow) -> property (null offsets && not (null observed))
    Right (Refused ZeroWindow) ->
      property (not (null offsets) && all (all (== 0)) contents) .&&. fitting === []
    Right (Refused NotInArray) ->
      property (not (null offsets) && all absent contents && any (any (/= 0)) contents)
        .&&. fitting === []
    Right (Refused OffSheet) -> on === Sheet .&&. fitting === [] .&&. length stickingOut === 1
    Right (Refused Contradiction) ->
      property (not (null offsets) && not (all absent contents))
        .&&. fitting === []
        .&&. stickingOut === []
    Right _ -> property False
    Left _ -> property False
  where
    outcome = locateRows table cells
    observed = [(i, j, a) | (i, r) <- zip [0 ..] cells, (j, Just a) <- zip [0 ..] r]
    at i j = [a | (i', j', a) <- observed, (i', j') == (i, j)]
    windows =
      [ (Position i j, content)
        | i <- [0 .. 4],
          j <- [0 .. 4],
          content <- [at i j ++ at i (j + 1) ++ at (i + 1) j ++ at (i + 1) (j + 1)],
          length content == 4
      ]
    offsets = map fst windows
    contents = map snd windows
    fits (Position r c) = and [cellAt array (Position (r + i) (c + j)) == a | (i, j, a) <- observed]
    fitting =
      [ p
        | p@(Position r c) <- everywhere,
          on /= Sheet || and [r + i < 15 && c + j < 17 | (i, j, _) <- observed],
          fits p
      ]
    onSheet r c = 0 <= r && r < 15 && 0 <= c && c < (17 :: Integer)
    stickingOut =
      [ (r, c)
        | on == Sheet,
          r <- [-5 .. 14],
          c <- [-5 .. 16],
          let shifted (i, j) = (r + toInteger i, c + toInteger j)
              onIt cell = uncurry onSheet (shifted cell),
          not (onSheet r c) || or [not (onIt (i, j)) | (i, j, _) <- observed],
          and
            [cellAt array (uncurry at' (shifted (i, j))) == a | (i, j, a) <- observed, onIt (i, j)],
          let present = [o | (o, content) <- windows, not (absent content)],
          not (null present),
          and [onIt (i, j) && onIt (i + 1, j + 1) | Position i j <- present]
      ]
    at' r c = Position (fromInteger r) (fromInteger c)
    standing =
      nub
        [ [cellAt array (Position (r + i) (c + j)) | i <- [0, 1], j <- [0, 1]]
          | Position r c <- everywhere,
            on /= Sheet || (r < 14 && c < 16)
        ]
    absent content = content `notElem` standing
