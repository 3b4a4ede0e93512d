{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}

-- | For each scene of touch, for networks and for poses, an answer just within its tolerance
-- passes, and one just beyond does not.
module Test.Conformance.Laws.Tolerances (spec) where

import Data.Foldable (for_)
import Data.Maybe (mapMaybe)
import PraTactile.Conformance
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Wire (readAnswer)
import PraTactile.Pose (Pose (..), RigidMotion (..))
import Test.Conformance.Laws.Trials
import Test.Hspec hiding (after, before)

spec :: Spec
spec = for_ scenes $ \(law, asked) ->
  it (lawId law) $ do
    let found = mapMaybe answered asked
    length found `shouldSatisfy` (>= 4)
    for_ found $ \(Answered passing within beyond) -> do
      map passing within `shouldSatisfy` and
      map passing beyond `shouldSatisfy` not . or
  where
    scenes =
      [ (law, map trial (draws 24 gen))
        | law <- lawsWithoutProfile,
          lawStage law `elem` touchStages || lawNeeds law == [OfPose],
          Cases _ (Some gen _) trial <- [lawCases law ()]
      ]
    answered trial = case askedBy (const (Left (Refusal "none"))) trial of
      (Violated violation, [SomeQuestion question])
        | Result wanted <- violationExpected violation ->
          readAnswer question wanted >>= variants trial question
      _ -> Nothing

-- | Whether an answer passes, and answers that should and should not.
data Answered = forall a. Answered (a -> Bool) [a] [a]

-- | Answers around the one that is wanted, of the same question.
variants :: Ask Verdict -> Question a -> a -> Maybe Answered
variants trial question wanted = case question of
  Register _ _ -> Just (Answered (\a -> passes (registering a) trial) within' beyond')
    where
      (within', beyond') = aroundRegistered wanted
  Stitch {} -> Just (Answered (\a -> passes (stitching a) trial) within' beyond')
    where
      (within', beyond') = aroundCorrections (toleranceOf wanted) wanted
  Segment _ -> Just (Answered (\a -> passes (segmenting a) trial) within' beyond')
    where
      (within', beyond') = aroundSymbols wanted
  Outputs _ _ ->
    let by size = [drop 1 wanted | size > 1e-9] ++ nearby (const size) wanted
     in Just (Answered (\a -> passes (telling a) trial) (by 0.9e-9) (by 1.1e-9))
  FacePose _ ->
    let by size = aroundPose size wanted
     in Just (Answered (\a -> passes (posing a) trial) (by 0.9e-9) (by 1.1e-9))
  _ -> Nothing
  where
    -- Where the robot made no error, a quarter of a taxel.
    toleranceOf corrections = if all (== (0, 0)) corrections then 0.25 else 0.5
    registering :: Registered -> Question b -> Either Refusal b
    registering answer asked = case asked of
      Register _ _ -> Right answer
      _ -> Left (Refusal "not-offered")
    stitching :: [Taxels] -> Question b -> Either Refusal b
    stitching answer asked = case asked of
      Stitch {} -> Right answer
      _ -> Left (Refusal "not-offered")
    segmenting :: [Symbol] -> Question b -> Either Refusal b
    segmenting answer asked = case asked of
      Segment _ -> Right answer
      _ -> Left (Refusal "not-offered")
    telling :: [Double] -> Question b -> Either Refusal b
    telling answer asked = case asked of
      Outputs _ _ -> Right answer
      _ -> Left (Refusal "not-offered")
    posing :: Pose -> Question b -> Either Refusal b
    posing answer asked = case asked of
      FacePose _ -> Right answer
      _ -> Left (Refusal "not-offered")

-- | With one of the numbers so much larger, or smaller.
nearby :: (Double -> Double) -> [Double] -> [[Double]]
nearby by values =
  [ before ++ (x + sign * by x) : after
    | (before, x : after) <- map (`splitAt` values) [0 .. length values - 1],
      sign <- [1, -1]
  ]

-- | With one number of the motion so many times itself and a millimetre further off.
aroundPose :: Double -> Pose -> [Pose]
aroundPose size pose =
  [ pose {poseMotion = RigidMotion (motionRows motion) by} | by <- each (motionBy motion)
  ]
    ++ [ pose {poseMotion = RigidMotion rows' (motionBy motion)}
         | (before, row' : after) <- map (`splitAt` motionRows motion) [0 .. 2],
           changed <- each row',
           let rows' = before ++ changed : after
       ]
  where
    motion = poseMotion pose
    each values =
      [ before ++ (x + size * (1 + abs x)) : after
        | (before, x : after) <- map (`splitAt` values) [0 .. 2]
      ]

-- | Half a taxel along each axis that is fixed; any displacement along the others. Another reason
-- never passes, nor do other axes where it is registered or refused for @one-axis@.
aroundRegistered :: Registered -> ([Registered], [Registered])
aroundRegistered wanted = (map at (concatMap (off 0.49) fixed ++ concatMap (off 9) loose), wrong)
  where
    at by = wanted {registeredBest = registeredBest wanted `plus` by}
    wrong =
      map at (concatMap (off 0.51) fixed)
        ++ [wanted {registeredReason = r} | r <- reasons, r /= registeredReason wanted]
        ++ [ wanted {registeredFixed = axes}
             | registeredReason wanted `elem` [Nothing, Just "one-axis"],
               axes <- [(x, y) | x <- [False, True], y <- [False, True]],
               axes /= told
           ]
    reasons = Nothing : map Just ["blank", "one-axis", "ambiguous", "no-overlap"]
    told = registeredFixed wanted
    fixed = [axis | (True, axis) <- [(fst told, (1, 0)), (snd told, (0, 1))]]
    loose = [axis | (False, axis) <- [(fst told, (1, 0)), (snd told, (0, 1))]]
    off size (x, y) = [(size * x, size * y), (-size * x, -size * y)]

-- | So many taxels of one frame from the mean of all; a shift of all means nothing.
aroundCorrections :: Double -> [Taxels] -> ([[Taxels]], [[Taxels]])
aroundCorrections tolerance wanted =
  ( wanted : map (plus (3.7, -2)) wanted : moved (tolerance - 0.01),
    moved (tolerance + 0.01) ++ [drop 1 wanted, wanted ++ take 1 wanted, []]
  )
  where
    count = fromIntegral (length wanted)
    -- If one alone is off, the mean is off by a part of that.
    moved size = [first' by | by <- sides (size * count / (count - 1))]
    first' by = map (`plus` by) (take 1 wanted) ++ drop 1 wanted

-- | Half a pixel, and five degrees, of one symbol, in any order; half turns mean nothing.
aroundSymbols :: [Symbol] -> ([[Symbol]], [[Symbol]])
aroundSymbols wanted =
  ( wanted : reverse wanted : map byPlace (sides 0.49) ++ map byAngle [4.9, -4.9, 180, -184.9],
    (Symbol (1, 1) 0 : wanted) : if null wanted then [] else drop 1 wanted : beyond
  )
  where
    beyond = map byPlace (sides 0.51) ++ map byAngle [5.1, -5.1, 90, 174.9]
    byPlace by = changed (\(Symbol place degrees) -> Symbol (place `plus` by) degrees)
    byAngle by = changed (\(Symbol place degrees) -> Symbol place (degrees + by))
    changed change = case wanted of
      one : rest -> change one : rest
      [] -> []

sides :: Double -> [Taxels]
sides d = [(d, 0), (-d, 0), (0, d), (0, -d)]

plus :: Taxels -> Taxels -> Taxels
plus (x, y) (x', y') = (x + x', y + y')
