-- | Tests the windows of a located grid against their definition, on grids with symbols that are
-- wrong, unsure, upside down, missing, or in doubt.
module Test.Recognition.WindowsByDefinition (spec) where

import Data.Foldable (for_)
import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, listToMaybe, mapMaybe)
import PraTactile.Array
import PraTactile.Field (KnownField)
import PraTactile.Geometry (rotated)
import PraTactile.Object.Placement
import PraTactile.Recognise
import PraTactile.Recognise.Finding
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.GridOutcome
import PraTactile.Symmetry
import Test.Effort (withCases)
import Test.Hspec
import Test.QuickCheck hiding (classes)
import Test.Recognition.Scenes
import Test.Recognition.Setting

spec :: Spec
spec =
  for_ [Shape 2 2, Shape 2 3, Shape 3 2, Shape 3 3] $ \window ->
    describe (unwords ["windows of", show (rows window), "x", show (columns window)]) $
      onPaperWith window $ \setting ->
        withCases 25 100 $
          it "windows with all of the array's symbols are found; without any, one with the most" $
            forAll (elements [Torus, Sheet]) $ \surface ->
              let onArray' = cellOf surface (settingArray setting)
                  reader = recogniserOn surface setting
               in forAllBlind (genScene onArray' [0]) $ \scene ->
                    let location =
                          GridLocation
                            (sceneOrientation scene)
                            (sceneCells scene)
                            Nothing
                            Nothing
                            GroupsApart
                        found = findingAt reader 0 location (scenePosition scene)
                     in foundAsDefined window (settingLayout setting) onArray' scene found
                          .&&. forAll
                            (choose (-45, 45))
                            (\skew -> foundSkewed reader skew location (scenePosition scene) found)

-- | Whether windows turn together with their symbols.
foundSkewed ::
  KnownField k =>
  Recogniser k ->
  Double ->
  GridLocation ->
  Position ->
  Maybe Finding ->
  Property
foundSkewed reader skew location position found =
  conjoin (zipWith close (seenIn found id) (seenIn (findingAt reader skew turnedSo position) back))
  where
    turnedSo = location {locationCells = Map.map (map skewed) (locationCells location)}
    skewed s = s {readAt = rotated skew (readAt s)}
    back = rotated (negate skew)
    seenIn answer place = concatMap (map (place . windowSeenAt) . windowsOf) answer
    windowsOf answer = foundWindow answer : foundWindows answer
    close (x, y) (x', y') =
      counterexample (show ((x, y), (x', y'))) (abs (x - x') + abs (y - y') < 1e-6)

-- | Whether the finding at a scene's position is the one by definition.
foundAsDefined :: Shape -> Placement -> OnArray -> Scene -> Maybe Finding -> Property
foundAsDefined window' layout onArray' (Scene orientation position cells) answered =
  label (if null complete then "incomplete" else "complete") $ case (answered, wanted) of
    (Just found, Just window) ->
      conjoin
        [ foundOrientation found === orientation,
          foundPlaces found
            === Map.fromList
              [ (readNumber s, SymbolPlace p c)
                | (cell, here) <- Map.toList cells,
                  Just (p, c) <- [at cell],
                  s <- here
              ],
          sameWindow (foundWindow found) window,
          length (foundWindows found) === length complete,
          conjoin (zipWith sameWindow (foundWindows found) complete)
        ]
    (Nothing, Nothing) -> property True
    (found, _) -> counterexample (show (isJust found, fmap third wanted)) False
  where
    at = onArray' position
    (high, wide) = (fromIntegral (rows window'), fromIntegral (columns window'))
    third (_, _, w) = w
    end part = maximum (0 : map part (Map.keys cells))
    -- Cells with a symbol that is the array's there.
    agreeing said =
      [ cell
        | (cell, here) <- Map.toList cells,
          Just (_, c) <- [at cell],
          any ((== Just (orientation, c)) . said) here
      ]
    right' = agreeing readClass
    known = if null right' then agreeing (Just . readLikeliest) else right'
    windowsFrom (top, left) =
      [ (cell, concat block, ReadWindow p classes (seenAt cell (concat block)) there)
        | cell@(i, j) <- (,) <$> [top .. end fst] <*> [left .. end snd],
          Just (p, _) <- [at cell],
          let block = [[(i + di, j + dj) | dj <- [0 .. wide - 1]] | di <- [0 .. high - 1]],
          let class' b = if b `elem` right' then snd <$> at b else Nothing,
          let classes = map (map class') block,
          let there = whereabouts layout window' p
      ]
    complete = filter (\(_, block, _) -> all (`elem` right') block) (windowsFrom (0, 0))
    -- The centre of the window by its symbols.
    seenAt (i, j) block =
      mean
        [ (x - dx, y - dy)
          | b@(i', j') <- block,
            s <- Map.findWithDefault [] b cells,
            let (x, y) = readAt s,
            let (dx, dy) =
                  onOffset
                    orientation
                    ( 16 * (fromIntegral (j' - j) - fromIntegral (wide - 1) / 2),
                      20 * (fromIntegral (i' - i) - fromIntegral (high - 1) / 2)
                    )
        ]
    mean places =
      let n = fromIntegral (max 1 (length places))
       in (sum (map fst places) / n, sum (map snd places) / n)
    felt (_, block, w) = (length (filter (`elem` known) block), isJust (faceOf w))
    faceOf w = case windowWhereabouts w of
      OnFace place -> Just (placeFace place)
      _ -> Nothing
    faces =
      nub
        [ placeFace place
          | Just (p, _) <- map at known,
            OnFace place <- [whereabouts layout (Shape 1 1) p]
        ]
    onTheFace =
      [ w
        | [face] <- [faces],
          w@(_, _, window) <- windowsFrom (1 - high, 1 - wide),
          fst (felt w) > 0,
          faceOf window == Just face
      ]
    wanted = listToMaybe (mapMaybe best [take 1 complete, onTheFace, windowsFrom (0, 0)])
    -- The first of those with the most.
    best ws = listToMaybe [w | w <- ws, felt w == maximum (map felt ws)]
    sameWindow a (_, _, b) =
      (windowPosition a, windowClasses a, windowWhereabouts a)
        === (windowPosition b, windowClasses b, windowWhereabouts b)
        .&&. near (fst (windowSeenAt a)) (fst (windowSeenAt b))
        .&&. near (snd (windowSeenAt a)) (snd (windowSeenAt b))

near :: Double -> Double -> Property
near a b = counterexample (show (a, b)) (abs (a - b) <= 1e-9 + 1e-6 * abs b)
