-- | Mistakes in registering two frames.
module PraTactile.Conformance.Impostors.Register
  ( registerImpostors,
  )
where

import Data.List (minimumBy)
import Data.Ord (comparing)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question.Touch

-- | In where a frame lies, and in why that is not told.
registerImpostors :: [Impostor]
registerImpostors = places ++ searches ++ reasons

places :: [Impostor]
places =
  [ answering "registers-x-backwards" "tells the displacement's error along x the other way" $
      \pair came ->
        let sx = fromInteger (fst (pairStep pair))
            (x, y) = registeredBest came
         in came {registeredBest = (2 * sx - x, y)},
    answering "registers-rows-for-columns" "takes down for right and right for down" $ \_ came ->
      let (x, y) = registeredBest came in came {registeredBest = (y, x)},
    answering "registers-one-off" "tells a displacement one taxel too far right" $ \_ came ->
      let (x, y) = registeredBest came in came {registeredBest = (x + 1, y)},
    answering "registers-to-the-middle" "tells the mean of the step and the displacement" $
      \pair came ->
        let (sx, sy) = pairStep pair
            (x, y) = registeredBest came
         in came {registeredBest = ((x + fromInteger sx) / 2, (y + fromInteger sy) / 2)},
    answering "trusts-the-step" "takes the step for the displacement" $ \pair came ->
      let (sx, sy) = pairStep pair in came {registeredBest = (fromInteger sx, fromInteger sy)}
  ]

searches :: [Impostor]
searches =
  [ asked "searches-one-taxel" "searches one taxel around the step, whatever it is to search" $
      \pair -> pair {pairSearch = min 1 (pairSearch pair)},
    asked "steps-forwards-only" "takes a step to the left or up for one to the right or down" $
      \pair -> pair {pairStep = (abs (fst (pairStep pair)), abs (snd (pairStep pair)))},
    asked "takes-the-least-frame" "cuts frames of two sizes to what both have" $ \pair ->
      let a = pairFirst pair
          b = pairSecond pair
          cut rows = [take (least concat' rows) row | row <- take (min (length a) (length b)) rows]
          least f _ = min (length (f a)) (length (f b))
          concat' = concat . take 1
       in pair {pairFirst = cut a, pairSecond = cut b},
    mistouched "compares-grey-values" "compares grey values as they are" $ \with ->
      with
        { register = \pair -> do
            came <- register with pair
            pure $ case registeredReason came of
              Nothing -> came {registeredBest = leastDifference pair}
              Just _ -> came
        }
  ]

-- | The whole displacement within the search at which the mean squared difference is least.
leastDifference :: Pair -> Taxels
leastDifference (Pair a b (sx, sy) search) =
  minimumBy
    (comparing difference)
    [(fromInteger x, fromInteger y) | x <- around sx, y <- around sy]
  where
    around s = [s - toInteger search .. s + toInteger search]
    difference (x, y) =
      let both =
            [ (fromIntegral u - fromIntegral v) ^ (2 :: Int)
              | (rowA, rowB) <- zip (from (round y) a) (from (negate (round y)) b),
                (u, v) <- zip (from (round x) rowA) (from (negate (round x)) rowB)
            ]
       in if null both then 1 / 0 else sum both / fromIntegral (length both) :: Double
    from :: Int -> [a] -> [a]
    from n = drop (max 0 n)

reasons :: [Impostor]
reasons =
  [ answering "registers-whatever-comes" "refuses nothing" $ \_ came ->
      came {registeredReason = Nothing, registeredFixed = (True, True)},
    answering "calls-every-refusal-ambiguous" "gives ambiguous for every other reason" $ \_ came ->
      came {registeredReason = "ambiguous" <$ registeredReason came},
    answering "calls-the-ambiguous-blank" "gives blank for ambiguous" $ \_ came ->
      came
        { registeredReason =
            (\r -> if r == "ambiguous" then "blank" else r) <$> registeredReason came
        },
    answering "names-the-other-axis" "takes the axis that is not fixed for the one that is" $
      \_ came -> case registeredReason came of
        Just "one-axis" ->
          let (x, y) = registeredFixed came in came {registeredFixed = (not x, not y)}
        _ -> came
  ]

-- | With another answer.
answering :: String -> String -> (Pair -> Registered -> Registered) -> Impostor
answering name mistake change =
  mistouched name mistake $ \with ->
    with {register = \pair -> change pair <$> register with pair}

-- | As if something else were asked.
asked :: String -> String -> (Pair -> Pair) -> Impostor
asked name mistake change =
  mistouched name mistake $ \with -> with {register = register with . change}
