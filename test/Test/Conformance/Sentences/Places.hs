{-# LANGUAGE GADTs #-}
{-# LANGUAGE RankNTypes #-}

-- | What impostors say of proofs and distances, of looking up and of correcting.
module Test.Conformance.Sentences.Places (spec, names) where

import Data.List (genericLength, sort, transpose)
import qualified Data.Map.Strict as Map
import Data.Maybe (catMaybes, fromMaybe, isJust, isNothing)
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Position (..), Shape (..), Surface (..))
import PraTactile.Conformance
import PraTactile.Conformance.Definition
import PraTactile.Conformance.Question
import PraTactile.Profile
import Test.Conformance.Sentences.Patches
import Test.Conformance.Sentences.Said
import Test.Hspec

spec :: Spec
spec = do
  describe "of proofs and distances" $ sentencesHold smallArrays maskQuestions ofProofs
  describe "of looking up" $ sentencesHold smallArrays patchQuestions (lookingUp ++ ofPatches)
  describe "of correcting" $ sentencesHold smallArrays patchQuestions (ofRadii ++ comparing)

-- | The impostors of which something is said here.
names :: [String]
names = map fst (ofProofs ++ lookingUp ++ ofPatches ++ ofRadii ++ comparing)

-- | All masks of up to 2 rows and 3 columns, some that are larger, and some that are none.
maskQuestions :: Known -> [SomeQuestion]
maskQuestions about =
  [ ask mask
    | mask <- masks,
      ask <- [SomeQuestion . Prove, SomeQuestion . Distance]
  ]
    ++ [SomeQuestion (Locate [[Just 1, Nothing, Just 1]]), SomeQuestion (Cell 1 1)]
  where
    Shape n1 n2 = profileShape (knownProfile about)
    n = fromIntegral (min 20 n2)
    masks =
      [ drawing
        | (i, j) <- [(1, 1), (1, 2), (2, 1), (2, 2), (1, 3), (3, 1), (2, 3)],
          drawing <- traverse (const (traverse (const "#.") [1 .. j :: Int])) [1 .. i :: Int]
      ]
        ++ [["####"], ["#####"], ["###", "###", "###"], [replicate n '#'], ['#' : replicate n '.']]
        ++ ["#" : replicate (fromIntegral n1) ".", ['#' : replicate (n - 1) '.'], ["##", "#"], []]

degree :: Known -> Natural
degree about = genericLength (profilePolynomial (knownProfile about)) - 1

cellsIn :: MaskRows -> Natural
cellsIn = genericLength . filter (== '#') . concat

ofProofs :: [Sentence]
ofProofs =
  [ overProof "proves-by-rank-alone" $ \about _ proof ->
      proof {proofHolds = proofRank proof == Just (degree about)},
    overProof "counts-windows-without-zeros" $ \about _ proof ->
      if proofRank proof == Just (degree about)
        then proof
        else proof {proofWindows = proofWindows proof - 1},
    overProof "has-a-rank-on-every-surface" $ \about mask proof ->
      proof {proofRank = Just (min (degree about) (cellsIn mask))},
    provingOn "proves-on-the-torus" $ \p -> case profileFolding p of
      Diagonal -> Torus
      RowMajor -> TwistedTorus,
    provingOn "proves-on-the-sheet" (const Sheet),
    ofMask "fills-the-mask" (map (map (\mark -> if mark == '.' then '#' else mark))),
    ofMask "cuts-the-mask" (take 1),
    -- Refused where the rectangle that is drawn goes beyond the sheet.
    saying "counts-blank-columns" $ \about question -> case question of
      Prove mask ->
        let Shape n1 n2 = profileShape (knownProfile about)
            beyond = genericLength mask > n1 || any ((> n2) . genericLength) mask
         in right about (Prove mask) >>= \proof ->
              if beyond && profileSurface (knownProfile about) == Sheet
                then refused "off-sheet"
                else Right proof
      _ -> right about question,
    overDistance "looks-at-different-windows-only" $ \_ _ d -> max 1 d,
    overDistance "takes-cells-for-the-distance" $ \about mask d ->
      if d == 0 then 0 else cellsIn mask - min (cellsIn mask) (degree about) + 1
  ]
  where
    overProof :: String -> (Known -> MaskRows -> Proof -> Proof) -> Sentence
    overProof name change = saying name $ \about question -> case question of
      Prove mask -> change about mask <$> right about (Prove mask)
      _ -> right about question
    overDistance :: String -> (Known -> MaskRows -> Natural -> Natural) -> Sentence
    overDistance name change = saying name $ \about question -> case question of
      Distance mask -> change about mask <$> right about (Distance mask)
      _ -> right about question
    ofMask :: String -> (MaskRows -> MaskRows) -> Sentence
    ofMask name change = saying name $ \about question -> case question of
      Prove mask -> right about (Prove (change mask))
      Distance mask -> right about (Distance (change mask))
      _ -> right about question
    provingOn :: String -> (Profile -> Surface) -> Sentence
    provingOn name surface =
      ( name,
        \about ->
          let (_, says) = elsewhere name (\p -> p {profileSurface = surface p})
              Says other = says about
           in Says $ \question -> case question of
                Prove mask -> other (Prove mask)
                _ -> right about question
      )

-- | How a patch is looked up: which of its windows, where it is if one of them is at a place, and
-- which places are kept, by the cells that agree there.
data Looking = Looking
  { windowsOf :: [(Integer, Integer)] -> [(Integer, Integer)],
    from :: Profile -> (Integer, Integer) -> (Integer, Integer) -> (Integer, Integer),
    keeps :: [Bool] -> Bool
  }

rightly :: Looking
rightly =
  Looking
    { windowsOf = id,
      from = \p (r, c) (i, j) -> fromMaybe (r - i, c - j) (wrapped p (r - i, c - j)),
      keeps = and
    }

-- | The places of the windows that occur, intersected, at which the observed cells agree.
lookedUp :: Known -> Surface' -> Looking -> Patch -> Either Refusal Place
lookedUp about surface how patch
  | noPatch about patch = invalid
  | Map.null observed = refused "too-few-cells"
  | null complete = refused "no-complete-window"
  | null occurring =
    refused (if all (all (== 0) . contentOf) complete then "zero-window" else "not-in-array")
  | not (null kept) = Right (placeOf (sort kept))
  | any (keeps how . catMaybes . agreeing) places = refused "off-sheet"
  | otherwise = refused "contradiction"
  where
    p = knownProfile about
    observed = observedIn patch
    Shape h w = profileWindow p
    window = [(i, j) | i <- [0 .. toInteger h - 1], j <- [0 .. toInteger w - 1]]
    complete =
      [ (i, j)
        | i <- [0 .. genericLength patch - 1],
          j <- [0 .. genericLength (head patch) - 1],
          all (\(a, b) -> Map.member (i + a, j + b) observed) window
      ]
    contentOf (i, j) = [observed Map.! (i + a, j + b) | (a, b) <- window]
    placesWith content =
      [ (r, c)
        | (r, c) <- everywhere p,
          map Just content == [surface (r + a, c + b) | (a, b) <- window]
      ]
    occurring = windowsOf how (filter (not . null . placesWith . contentOf) complete)
    places = [at | at <- concat (take 1 found), all (at `elem`) found]
    found =
      [ map (\at -> from how p at offset) (placesWith (contentOf offset))
        | offset <- occurring
      ]
    agreeing (r, c) =
      [(== code) <$> surface (r + i, c + j) | ((i, j), code) <- Map.toList observed]
    kept =
      [at | at <- places, isJust (surface at), maybe False (keeps how) (sequence (agreeing at))]

-- | Of looking up with a mistake; and so where nothing is to be corrected and nothing agrees.
looking :: String -> Looking -> Sentence
looking name how =
  ( name,
    \about ->
      let surface = surfaceOf about
       in Says $ \question -> case question of
            Locate patch -> lookedUp about surface how patch
            Nearest radius patch ->
              nearestBy about surface (lookedUp about surface how) rightlyCompared radius patch
            _ -> right about question
  )

lookingUp :: [Sentence]
lookingUp =
  [ looking "looks-at-the-first-window" rightly {windowsOf = take 1, keeps = const True},
    looking "looks-at-the-windows-alone" rightly {keeps = const True},
    looking "lets-the-majority-decide" $
      rightly {keeps = \agree -> length (filter id agree) > length (filter not agree)},
    looking "tells-the-windows-place" rightly {from = \_ at _ -> at},
    looking "adds-the-offset" $
      rightly {from = \p at (i, j) -> from rightly p at (negate i, negate j)},
    looking "forgets-to-wrap" $
      rightly
        { from = \p (r, c) (i, j) ->
            if profileSurface p == Sheet then (r - i, c - j) else (max 0 (r - i), max 0 (c - j))
        }
  ]

-- | Of patches that are taken otherwise, and of places that are told otherwise.
ofPatches :: [Sentence]
ofPatches =
  [ told "begins-at-the-origin" $ \came -> case came of
      Left (Refusal why)
        | why `elem` ["zero-window", "not-in-array", "off-sheet", "contradiction"]
            || why == "beyond-radius" ->
          Right (At (Position 0 0))
      _ -> came,
    told "takes-the-first-of-several-places" $ \came -> case came of
      Right (OneOf several) -> Right (At (head several))
      _ -> came,
    told "takes-the-last-of-several-places" $ \came -> case came of
      Right (OneOf several) -> Right (At (last several))
      _ -> came,
    given "drops-the-first-row" $ \patch ->
      if length patch > 2 then map (const Nothing) (head patch) : tail patch else patch,
    given "takes-cells-not-felt-for-zeros" (map (map (Just . fromMaybe 0))),
    saying "refuses-cells-not-felt" $ \about question -> case question of
      Locate patch
        | not (noPatch about patch),
          any isJust (concat patch),
          any isNothing (concat patch) ->
          refused "too-few-cells"
      _ -> right about question,
    seen "transposes-patches" transpose,
    saying "mirrors-patches" $ \about question -> case question of
      Locate patch -> right about (Locate (map reverse patch))
      Nearest radius patch -> right about (Nearest radius (map reverse patch))
      Posterior chances -> right about (Posterior (map reverse chances))
      _ -> right about question,
    seen "turns-patches" (reverse . map reverse),
    place "is-one-column-beside" $ \about (Position r c) ->
      Position r ((c + 1) `mod` columns (profileShape (knownProfile about))),
    place "counts-places-from-one" $ \_ (Position r c) -> Position (r + 1) (c + 1)
  ]
  where
    told :: String -> (Either Refusal Place -> Either Refusal Place) -> Sentence
    told name change = saying name $ \about question -> case question of
      Locate patch -> change (right about (Locate patch))
      Nearest radius patch -> change (right about (Nearest radius patch))
      _ -> right about question
    place :: String -> (Known -> Position -> Position) -> Sentence
    place name change = saying name $ \about question -> case question of
      Locate patch -> moved (change about) <$> right about (Locate patch)
      Nearest radius patch -> moved (change about) <$> right about (Nearest radius patch)
      _ -> right about question
    moved change found = case found of
      At at -> At (change at)
      OneOf several -> OneOf (map change several)
      other -> other
    seen :: String -> (Patch -> Patch) -> Sentence
    seen name change = saying name $ \about question -> case question of
      Locate patch -> right about (Locate (change patch))
      Nearest radius patch -> right about (Nearest radius (change patch))
      _ -> right about question
    -- What is no patch is refused before.
    given :: String -> (Patch -> Patch) -> Sentence
    given name change = saying name $ \about question -> case question of
      Locate patch | not (noPatch about patch) -> right about (Locate (change patch))
      Nearest radius patch
        | not (noPatch about patch) -> right about (Nearest radius (change patch))
      _ -> right about question

-- | How positions are compared: how many cells differ, given what was seen and what is there, and
-- whether so many are within a radius.
data Comparing = Comparing
  { differ :: Code -> Code -> Natural,
    within :: Natural -> Natural -> Bool
  }

rightlyCompared :: Comparing
rightlyCompared = Comparing {differ = \a b -> if a == b then 0 else 1, within = (<=)}

-- | The positions that differ least, if that is within the radius, stated or guaranteed.
nearestBy ::
  Known ->
  Surface' ->
  (Patch -> Either Refusal Place) ->
  Comparing ->
  Maybe Natural ->
  Patch ->
  Either Refusal Place
nearestBy about surface lookUp how stated patch
  | noPatch about patch = invalid
  | Map.null observed = refused "too-few-cells"
  | not (null counted) && within how least radius =
    Right (placeOf [at | (n, at) <- counted, n == least])
  | radius == 0 && complete = lookUp patch
  | radius == 0 = refused (if nonzero == 0 then "zero-window" else "contradiction")
  | nonzero <= radius = refused "zero-window"
  | otherwise = refused "beyond-radius"
  where
    observed = observedIn patch
    radius = fromMaybe (guaranteedBy (distanceOf about patch)) stated
    counted =
      [ (sum (zipWith (differ how) (Map.elems observed) there), (r, c))
        | (r, c) <- everywhere (knownProfile about),
          Just there <- [traverse (\(i, j) -> surface (r + i, c + j)) (Map.keys observed)]
      ]
    least = minimum (map fst counted)
    nonzero = genericLength (filter (/= 0) (Map.elems observed))
    complete = right about (Locate patch) /= refused "no-complete-window"

-- | The largest e with 2 e < d.
guaranteedBy :: Natural -> Natural
guaranteedBy d = last (0 : [e | e <- [1 .. d], 2 * e < d])

-- | The least number of cells in which two contents of the observed cells differ.
distanceOf :: Known -> Patch -> Natural
distanceOf about patch =
  either (const 0) id (right about (Distance (map (map (maybe '.' (const '#'))) patch)))

ofRadii :: [Sentence]
ofRadii =
  [ guaranteeing "corrects-one-too-many" $ \about patch ->
      guaranteedBy (distanceOf about patch) + 1,
    guaranteeing "corrects-one-too-few" $ \about patch ->
      let e = guaranteedBy (distanceOf about patch) in if e == 0 then 0 else e - 1,
    guaranteeing "corrects-half-the-distance" (\about patch -> distanceOf about patch `div` 2),
    guaranteeing "corrects-the-whole-distance" $ \about patch ->
      let d = distanceOf about patch in if d == 0 then 0 else d - 1,
    guaranteeing "measures-the-whole-patch" $ \about patch ->
      guaranteedBy (distanceOf about (map (map (const (Just 0))) patch)),
    guaranteeing "measures-the-first-row" $ \about patch ->
      guaranteedBy (distanceOf about (take 1 (filter (any isJust) patch))),
    compared "stops-before-the-radius" $
      rightlyCompared {within = \n radius -> n < radius || n == 0 && radius == 0},
    compared "corrects-beyond-the-radius" rightlyCompared {within = \n radius -> n <= radius + 1},
    saying "knows-the-guaranteed-radius-alone" $ \about question -> case question of
      Nearest _ patch -> right about (Nearest Nothing patch)
      _ -> right about question,
    saying "takes-no-radius-for-none" $ \about question -> case question of
      Nearest Nothing patch -> right about (Nearest (Just 0) patch)
      _ -> right about question
  ]
  where
    guaranteeing :: String -> (Known -> Patch -> Natural) -> Sentence
    guaranteeing name radius = saying name $ \about question -> case question of
      Nearest Nothing patch
        | not (noPatch about patch),
          any isJust (concat patch) ->
          right about (Nearest (Just (radius about patch)) patch)
      _ -> right about question

-- | With a mistake in how positions are compared.
compared :: String -> Comparing -> Sentence
compared name how =
  ( name,
    \about ->
      let surface = surfaceOf about
       in Says $ \question -> case question of
            Nearest radius patch ->
              nearestBy about surface (right about . Locate) how radius patch
            _ -> right about question
  )

comparing :: [Sentence]
comparing =
  [ saying "takes-erasures-for-zeros" $ \about question -> case question of
      Nearest radius patch -> right about (Nearest radius (map (map (Just . fromMaybe 0)) patch))
      _ -> right about question,
    compared "counts-how-far-codes-are" $
      rightlyCompared {differ = \a b -> if a > b then a - b else b - a},
    compared "forgives-zeros" $
      rightlyCompared {differ = \seen there -> if seen == there || seen == 0 then 0 else 1},
    saying "corrects-what-is-complete" $ \about question -> case question of
      Nearest _ patch
        | any isNothing (concat patch), any isJust (concat patch) -> right about (Locate patch)
      _ -> right about question,
    saying "looks-up-instead-of-comparing" $ \about question -> case question of
      Nearest _ patch -> right about (Locate patch)
      _ -> right about question,
    overSeveral "answers-a-tie" (At . head),
    overSeveral "hides-the-places" (\several -> Coset (genericLength several) 0)
  ]
  where
    overSeveral :: String -> ([Position] -> Place) -> Sentence
    overSeveral name change = saying name $ \about question -> case question of
      Nearest radius patch ->
        ( \found -> case found of
            OneOf several -> change several
            other -> other
        )
          <$> right about (Nearest radius patch)
      _ -> right about question
