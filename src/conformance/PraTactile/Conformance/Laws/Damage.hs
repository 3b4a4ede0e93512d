-- | Locating with cells that are missing and cells that are wrong.
module PraTactile.Conformance.Laws.Damage
  ( damageLaws,
  )
where

import Control.Monad.Trans.Except (runExceptT)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), naturalsBelow, shapeCells)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Definition
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | The laws of the nearest position, for arrays of at most 1024 cells: distances are computed by
-- comparing all windows.
damageLaws :: [Law Session]
damageLaws = correctionLaws ++ definitionLaws ++ refusalLaws

-- | A law of patches that are drawn and compared with all positions; few of them, because each
-- compares all windows with all.
compared :: String -> (Session -> Looked -> Property) -> Law Session
compared name law = Law name (\s -> lookedAt s (withMaxSuccess 30 . law s))

-- | What is corrected for certain.
correctionLaws :: [Law Session]
correctionLaws =
  [ compared
      "s missing and e wrong cells are corrected if 2 e + s < d, the least number of cells in \
      \which two windows of the patch's shape differ"
      (\s looked -> forSeenWithin looked s (corrects s looked)),
    compared
      "the cells observed decide: e of them wrong are corrected if 2 e < d, the least number in \
      \which two contents of them differ"
      ( \s looked ->
          forDamaged s 25 8 $ \seen ->
            let d = leastDistance looked (map fst (observedOf (patchOf looked seen)))
             in 2 * fromIntegral (length (seenWrong seen)) < d ==> corrects s looked seen
      )
  ]
  where
    corrects s looked seen =
      equal (nearest s Nothing (patchOf looked seen)) (pure (At (seenPlace seen)))

-- | That any patch is answered as comparing it with all positions says.
definitionLaws :: [Law Session]
definitionLaws =
  [ compared
      "any patch is located, ambiguous or refused as comparing it with all positions says, to the \
      \guaranteed radius"
      (\s looked -> forDamaged s 20 20 (asDefined looked s Nothing . patchOf looked)),
    compared
      "any patch is located, ambiguous or refused as comparing it with all positions says, to a \
      \radius that is stated"
      ( \s looked ->
          forAllShrink (chooseInteger (0, 4)) shrink $ \e ->
            forDamaged s 20 20 (asDefined looked s (Just (fromInteger (abs e))) . patchOf looked)
      ),
    compared
      "cells too few to tell a position are answered with all positions that agree, or with how \
      \many they are"
      (\s looked -> forDamaged s 75 0 (asDefined looked s Nothing . patchOf looked)),
    compared
      "beyond the edge of the surface there is nothing to agree with: a patch across it is as \
      \comparing it with all positions says"
      ( \s looked ->
          let Shape high wide = profileWindow (profile s)
              Shape n1 n2 = profileShape (profile s)
              -- As the torus continues it, whatever the surface.
              wrapped place = patchOf (onTorus looked) (Seen place larger [] [])
              larger = Shape (high + 1) (wide + 1)
           in once
                ( conjoin
                    [ asDefined looked s Nothing (wrapped (Position (n1 - 1) c))
                      | c <- [0, n2 - 1]
                    ]
                )
      )
  ]

-- | What is refused.
refusalLaws :: [Law Session]
refusalLaws =
  [ compared
      "zeros, and with them as few other cells as are corrected, are refused where windows of the \
      \shape differ: zero-window"
      ( \s looked ->
          forDamaged s 0 10 $ \seen ->
            let Shape high wide = seenShape seen
                d = leastDistance looked (shapeCells (seenShape seen))
                zeros =
                  [ [ Just (fromMaybe 0 (lookup (Position i j) (seenWrong seen)))
                      | j <- naturalsBelow wide
                    ]
                    | i <- naturalsBelow high
                  ]
             in d > 0 && fromIntegral (length (seenWrong seen)) <= radiusOf d
                  ==> refuses "zero-window" (nearest s Nothing zeros)
      ),
    Law
      "a patch of which nothing was observed is refused: too-few-cells, and what is no patch: \
      \invalid"
      ( \s ->
          once
            ( conjoin
                [ refuses "too-few-cells" (nearest s Nothing [[Nothing, Nothing]]),
                  refuses "invalid" (nearest s Nothing []),
                  refuses "invalid" (nearest s Nothing [[Just 0, Just 1], [Just 1]]),
                  refuses "invalid" (nearest s Nothing [[Just (profileOrder (profile s))]])
                ]
            )
      )
  ]

-- | For patches of shapes around the window, with these percentages of cells not observed, and of
-- the others wrong.
forDamaged :: Session -> Int -> Int -> (Seen -> Property) -> Property
forDamaged s erased wrong =
  forSeen (genSeen (profile s) (shapesAround (profile s)) (Damage erased wrong))

-- | Patches with as much damage as the distance of their shape forgives.
forSeenWithin :: Looked -> Session -> (Seen -> Property) -> Property
forSeenWithin looked s = forSeen damaged
  where
    damaged = do
      seen <- genSeen (profile s) (shapesAround (profile s)) undamaged
      let offsets = shapeCells (seenShape seen)
          d = leastDistance looked offsets
      -- Where nothing is forgiven, a window without damage.
      if d == 0
        then genSeen (profile s) [profileWindow (profile s)] undamaged
        else do
          missing <- fromInteger <$> chooseInteger (0, toInteger d - 1)
          e <- fromInteger <$> chooseInteger (0, toInteger (d - 1 - missing) `div` 2)
          hit <- shuffle offsets
          by <-
            vectorOf
              (fromIntegral (e :: Natural))
              (fromInteger <$> chooseInteger (1, toInteger (profileOrder (profile s)) - 1))
          let (gone, others) = splitAt (fromIntegral missing) hit
          pure seen {seenGone = gone, seenWrong = zip others by}

-- | What comparing a patch with all positions says.
asDefined :: Looked -> Session -> Maybe Natural -> [[Maybe Code]] -> Property
asDefined looked s stated cells
  | null observed = refuses "too-few-cells" (nearest s stated cells)
  | Just e <- least, e <= radius = located (map snd (filter ((== least) . Just . fst) counted))
  | radius == 0 = refused (const True)
  | weight <= radius = refused (== "zero-window")
  | otherwise = refused (== "beyond-radius")
  where
    observed = observedOf cells
    offsets = map fst observed
    radius = fromMaybe (radiusOf (leastDistance looked offsets)) stated
    counted =
      [ ( fromIntegral
            (length (filter id (zipWith (/=) content (map (fromIntegral . snd) observed)))),
          place
        )
        | (place, content) <- contentsAt (profileSurface (profile s)) looked offsets
      ] ::
        [(Natural, Position)]
    least = if null counted then Nothing else Just (minimum (map fst counted))
    weight = fromIntegral (length (filter ((/= 0) . snd) observed))
    answered condition = ioProperty $ do
      outcome <- runExceptT (nearest s stated cells)
      pure
        ( counterexample
            ("answered " ++ show outcome ++ "; nearest are " ++ show (take 3 counted))
            (condition outcome)
        )
    located places = answered $ \outcome -> case (outcome, places) of
      (Right (At place), [only]) -> place == only
      (Right (OneOf several), _ : _ : _) -> several == places
      (Right (Coset count _), _ : _ : _) -> count == fromIntegral (length places)
      _ -> False
    refused condition = answered (either (condition . refusalReason) (const False))
