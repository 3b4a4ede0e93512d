{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Impostors of locating.
module PraTactile.Conformance.Impostors.Places
  ( locateImpostors,
    damageImpostors,
    chanceImpostors,
  )
where

import Control.Monad.Trans.Except (catchE, throwE)
import Data.List (elemIndex)
import Data.Maybe (fromMaybe, isJust)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (Position), shapeCells)
import PraTactile.Conformance.Definition (ProfileFacts, knownProfile)
import PraTactile.Conformance.Definition.Locate (guaranteedRadius)
import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Impostors.Impostor
import PraTactile.Conformance.Question
import PraTactile.Profile (Profile (..))

-- | Mistakes in locating by the table.
locateImpostors :: [Impostor]
locateImpostors =
  [ located
      "looks-at-the-first-window"
      "looks up the first complete window of a patch, and at no other cell"
      $ \k rows -> case completeWindows k rows of
        cells : _ ->
          [ [if (i, j) `elem` cells then cell else Nothing | (j, cell) <- zip [0 ..] row]
            | (i, row) <- zip [0 ..] rows
          ]
        [] -> rows,
    placing "begins-at-the-origin" "has (0, 0) as the place until a better one is found" $
      \place ->
        place `catchE` \why ->
          if refusalReason why `elem` ["contradiction", "not-in-array", "beyond-radius"]
            then pure (At (Position 0 0))
            else throwE why,
    placing "takes-the-first-of-several-places" "answers the first of several places" $
      fmap $ \place -> case place of
        OneOf (first : _) -> At first
        _ -> place,
    answeringOtherwise
      "refuses-cells-not-felt"
      "refuses a patch of which a cell was not felt as one of which none was"
      $ \_ right question -> case question of
        Locate :? rows
          | any (any isJust) rows && any (elem Nothing) rows ->
            right (Locate :? map (map (const Nothing)) rows)
        _ -> right question,
    felt "takes-cells-not-felt-for-zeros" "takes a cell that was not felt for a 0" $
      map (map (Just . fromMaybe 0)),
    placing "counts-places-from-one" "counts the rows and columns of places from 1" $
      fmap (overPositions (\(Position r c) -> Position (r + 1) (c + 1)))
  ]
  where
    located :: String -> String -> (ProfileFacts -> Patch -> Patch) -> Impostor
    located name mistake change =
      answeringOtherwise name mistake $ \k right question -> case question of
        Locate :? rows -> right (Locate :? change k rows)
        _ -> right question
    felt :: String -> String -> (Patch -> Patch) -> Impostor
    felt name mistake change =
      answeringOtherwise name mistake $ \_ right question -> case question of
        Locate :? rows -> right (Locate :? change rows)
        Nearest :? (radius, rows) -> right (Nearest :? (radius, change rows))
        _ -> right question
    placing :: String -> String -> (Wire Location -> Wire Location) -> Impostor
    placing name mistake change =
      answeringOtherwise name mistake $ \_ right question -> case question of
        Locate :? _ -> change (right question)
        Nearest :? (_, _) -> change (right question)
        _ -> right question

-- | The cells of each completely observed window of a patch, row by row.
completeWindows :: ProfileFacts -> Patch -> [[(Natural, Natural)]]
completeWindows k rows =
  [ cells
    | (i, j) <- map fst seen,
      let cells = [(i + a, j + b) | Position a b <- shapeCells (profileWindow (knownProfile k))],
      all (\cell -> isJust (lookup cell seen)) cells
  ]
  where
    seen = [((i, j), code) | (i, row) <- zip [0 ..] rows, (j, Just code) <- zip [0 ..] row]

overPositions :: (Position -> Position) -> Location -> Location
overPositions change place = case place of
  At at -> At (change at)
  OneOf several -> OneOf (map change several)
  Coset count dimension -> Coset count dimension

-- | Mistakes in correcting wrong cells.
damageImpostors :: [Impostor]
damageImpostors =
  [ nearing "corrects-half-the-distance" "corrects e cells if 2 e <= d" $ \right radius rows -> do
      d <- distanceOf right (map (map isJust) rows)
      right (Nearest :? (Just (fromMaybe (d `div` 2) radius), rows)),
    nearing
      "measures-the-whole-patch"
      "takes the distance of the whole patch, also where cells are missing"
      $ \right radius rows -> do
        d <- distanceOf right (map (map (const True)) rows)
        right (Nearest :? (Just (fromMaybe (guaranteedRadius d) radius), rows)),
    nearing "stops-before-the-radius" "takes a radius as a bound that is not reached" $
      \right radius rows ->
        right (Nearest :? ((\e -> if e == 0 then 0 else e - 1) <$> radius, rows)),
    nearing "takes-no-radius-for-none" "corrects nothing where no radius is stated" $
      \right radius rows -> right (Nearest :? (Just (fromMaybe 0 radius), rows))
  ]
  where
    nearing ::
      String ->
      String ->
      (RightAnswers -> Maybe Natural -> Patch -> Wire Location) ->
      Impostor
    nearing name mistake change =
      answeringOtherwise name mistake $ \_ right question -> case question of
        Nearest :? (radius, rows) -> change right radius rows
        _ -> right question
    distanceOf :: RightAnswers -> [[Bool]] -> Wire Natural
    distanceOf right cells =
      right (Distance :? map (map (\counts -> if counts then '#' else '.')) cells)

-- | Mistakes in probabilities.
chanceImpostors :: [Impostor]
chanceImpostors =
  [ believing "hears-the-likeliest-symbol" "takes of each cell the likeliest symbol for certain" $
      \_ chance -> case chance of
        Probably numbers
          | Just i <- elemIndex (maximum (0 : numbers)) numbers -> Certainly (fromIntegral i)
        _ -> chance,
    believing "takes-the-unknown-for-zeros" "takes a cell of which nothing is known for a 0" $
      \_ chance -> if chance == Unfelt then Certainly 0 else chance,
    believing "takes-any-numbers-for-probabilities" "divides any numbers by their sum" $
      \q chance -> case chance of
        Probably numbers
          | total <- sum (map (max 0) numbers),
            total > 0 ->
            Probably (take (fromIntegral q) (map ((/ total) . max 0) numbers ++ repeat 0))
        _ -> chance,
    telling "multiplies-numbers-as-they-come" "multiplies probabilities without dividing by sums" $
      \cells -> map (fmap (* product [sum numbers | Probably numbers <- concat cells])),
    telling "divides-by-the-largest" "divides by the largest likelihood instead of the sum" $
      \_ found -> map (fmap (/ maximum (map snd found))) found
  ]
  where
    believing :: String -> String -> (Natural -> Chance -> Chance) -> Impostor
    believing name mistake change =
      answeringOtherwise name mistake $ \k right question -> case question of
        Posterior :? cells ->
          let q = profileOrder (knownProfile k)
           in right (Posterior :? map (map (change q)) cells)
        _ -> right question
    telling ::
      String ->
      String ->
      (Chances -> [(Position, Double)] -> [(Position, Double)]) ->
      Impostor
    telling name mistake change =
      answeringOtherwise name mistake $ \_ right question -> case question of
        Posterior :? cells -> change cells <$> right question
        _ -> right question
