-- | Locating from probabilities.
module PraTactile.Conformance.Laws.Chances
  ( chanceLaws,
  )
where

import Control.Monad.Trans.Except (runExceptT)
import Data.List (sort)
import qualified Data.Map.Strict as Map
import Data.Ratio ((%))
import PraTactile.Array (Position (..), Shape (..), naturalsBelow)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Definition
import PraTactile.Profile (Profile (..))
import Test.QuickCheck hiding (total)

-- | The laws of the probabilities of positions, for arrays of at most 1024 cells.
chanceLaws :: [Law Session]
chanceLaws =
  [ Law
      "the probability of a position is the product of the probabilities of its symbols, divided \
      \by the sum over all positions (Bayes)"
      (\s -> lookedAt s (\looked -> few (forChances s (asBayes looked s)))),
    Law
      "of symbols beyond doubt all positions that agree are equally likely, and no others"
      ( \s ->
          lookedAt s $ \looked ->
            few $
              forSeen
                (genSeen (profile s) (shapesAround (profile s)) (Damage 30 5))
                (asBayes looked s . map (map (fmap (certain s))) . patchOf looked)
      ),
    Law
      "numbers that are no probabilities are refused: invalid"
      ( \s ->
          let q = fromIntegral (profileOrder (profile s))
              uniform = replicate (q - 1) (1 / fromIntegral (q - 1))
           in once
                ( conjoin
                    [ refuses "invalid" (posterior s [[Just uniform]]),
                      refuses "invalid" (posterior s [[Just (2 : -1 : replicate (q - 2) 0)]]),
                      refuses "invalid" (posterior s [[Just (replicate q 0)]]),
                      refuses "invalid" (posterior s [])
                    ]
                )
      )
  ]
  where
    few = withMaxSuccess 30
    certain s code = [if c == code then 64 else 0 | c <- naturalsBelow (profileOrder (profile s))]

-- | For patches in which each cell that was observed has the probabilities of all symbols, in
-- 64ths.
forChances :: Session -> ([[Maybe [Integer]]] -> Property) -> Property
forChances s =
  forAllShrink
    patches
    ( \rows' ->
        [ take i rows' ++ [shorter] ++ drop (i + 1) rows'
          | (i, line) <- zip [0 ..] rows',
            shorter <- forgotten line
        ]
    )
  where
    p = profile s
    patches = do
      Shape h w <- elements (shapesAround p)
      vectorOf
        (fromIntegral h)
        (vectorOf (fromIntegral w) (frequency [(1, pure Nothing), (4, Just <$> chances)]))
    chances = do
      cuts <- vectorOf (fromIntegral (profileOrder p) - 1) (chooseInteger (0, 64))
      let ends = sort cuts
      shuffle (zipWith (-) (ends ++ [64]) (0 : ends))
    -- One cell less is known.
    forgotten line =
      [take j line ++ [Nothing] ++ drop (j + 1) line | (j, Just _) <- zip [0 ..] line]

-- | In exact fractions.
asBayes :: Looked -> Session -> [[Maybe [Integer]]] -> Property
asBayes looked s rows' = ioProperty $ do
  outcome <- runExceptT (posterior s (map (map (fmap (map ((/ 64) . fromInteger)))) rows'))
  pure $
    counterexample (take 2000 (show outcome)) $ case outcome of
      Left found -> sum (map snd exact) === 0 .&&. found === Refusal "contradiction"
      Right answered ->
        let given = Map.fromList answered
            expected = Map.fromList exact
         in conjoin
              [ counterexample "the same position twice" (Map.size given === length answered),
                counterexample
                  "positions that cannot be"
                  (all (`Map.member` expected) (Map.keys given)),
                property (total > 0),
                conjoin
                  [ counterexample
                      (show place ++ " has " ++ show (fromRational (chance / total) :: Double))
                      ( abs (Map.findWithDefault 0 place given - fromRational (chance / total))
                          < 1e-9
                      )
                    | total > 0,
                      (place, chance) <- exact
                  ]
              ]
  where
    known =
      [ (Position i j, chances)
        | (i, line) <- zip [0 ..] rows',
          (j, Just chances) <- zip [0 ..] line
      ]
    exact =
      [ (place, product (zipWith (\code chances -> (chances !! code) % 64) content (map snd known)))
        | (place, content) <- contentsAt (profileSurface (profile s)) looked (map fst known)
      ]
    total = sum (map snd exact)
