{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The laws of registration of two frames: the displacement is where both show the same relief,
-- and if they do not determine it, the refusal has the right reason.
module PraTactile.Conformance.Laws.Register
  ( registerLaws,
  )
where

import Data.Aeson (Value (Null))
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Relief
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (Codec, int, integer, key, nullable, object, pairOf)
import PraTactile.Symmetry (onOffset)
import Test.QuickCheck (Gen, chooseInt, elements, shrinkIntegral)

-- | The laws of registration.
registerLaws :: [Law ()]
registerLaws = placeLaws ++ [latticeLaw] ++ refusalLaws ++ [invalidLaw]

-- | Two frames of a relief. The fields are the relief's seed, the frames' width and height, the
-- robot's nominal step, its error, a number that selects a change, and the number of classes whose
-- shapes are given.
data FramePair = FramePair
  { pressSeed :: Int,
    pressSize :: WholeTaxels,
    pressStep :: WholeTaxels,
    pressError :: WholeTaxels,
    pressChange :: Int,
    pressShapes :: Maybe Int
  }

pressForm :: Codec FramePair
pressForm =
  object $
    FramePair
      <$> key "relief" int pressSeed
      <*> key "size" (pairOf integer) pressSize
      <*> key "step" (pairOf integer) pressStep
      <*> key "error" (pairOf integer) pressError
      <*> key "change" int pressChange
      <*> key "shapes" (nullable int) pressShapes

genPress :: Gen FramePair
genPress =
  FramePair <$> genSeed
    <*> elements [(16, 16), (20, 16), (16, 20)]
    <*> elements [(8, 0), (0, 8), (8, 2), (3, 8)]
    <*> genError 2
    <*> chooseInt (0, 999)
    <*> genShapes

-- | A press with a smaller error, frames of 16 x 16, a step to the right, or less of a change.
smallerPress :: FramePair -> [FramePair]
smallerPress press =
  [press {pressError = e} | e <- smallerWhole (pressError press)]
    ++ [press {pressSize = (16, 16)} | pressSize press /= (16, 16)]
    ++ [press {pressStep = (8, 0)} | pressStep press /= (8, 0)]
    ++ [press {pressChange = c} | c <- shrinkIntegral (pressChange press), c >= 0]
    ++ [press {pressShapes = Nothing} | Just _ <- [pressShapes press]]

-- | The displacement, and the pair of frames with a search of 3 taxels.
pressed :: FramePair -> (WholeTaxels, Pair)
pressed (FramePair seed size step by _ _) =
  (shift, Pair (cut (0, 0)) (cut shift) step 3)
  where
    shift = moved step by
    cut = frameOf size (bumpy seed)

placeLaws :: [Law ()]
placeLaws =
  [ placed
      "known-displacement"
      "two frames cut from one relief are registered as they were cut, to half a taxel"
      "both show the same relief there, and within the search nowhere else"
      (const id),
    placed
      "gain-and-offset"
      "a gain and an offset of each frame's grey values change nothing"
      "gain and offset of grey values are not relief"
      ( \n (shift, Pair a b step search) ->
          let change k = affinely (Affine (fromIntegral (1 + k `mod` 3)) (fromIntegral (k * 5)))
           in (shift, Pair (change n a) (change (n `div` 3) b) step search)
      ),
    placed
      "exchanged"
      "exchanging the two frames reverses the displacement"
      "if B lies at d in A, A lies at -d in B"
      (\_ (shift, Pair a b step search) -> (back shift, Pair b a (back step) search)),
    placed
      "turned-and-mirrored"
      "turning or mirroring both frames turns or mirrors the displacement"
      "the displacement belongs to the scene, whichever way it is seen"
      ( \n (shift, Pair a b step search) ->
          let (symmetry, rows) = seen n
           in ( onOffset symmetry shift,
                Pair (rows a) (rows b) (onOffset symmetry step) search
              )
      ),
    placed
      "another-step"
      "another step changes nothing, if the displacement is within the search around it"
      "the step only determines where to search"
      ( \n (shift, Pair a b (sx, sy) search) ->
          let toward t d = if t + 1 - d > 3 then t - 1 else t + 1
           in if even n
                then (shift, Pair a b (toward sx (fst shift), sy) search)
                else (shift, Pair a b (sx, toward sy (snd shift)) search)
      )
  ]
  where
    back (x, y) = (negate x, negate y)

-- | A law that a changed pair is registered at its displacement.
placed ::
  String -> String -> String -> (Int -> (WholeTaxels, Pair) -> (WholeTaxels, Pair)) -> Law ()
placed what sentence reason change =
  law OnRegister what [SomeOp Register] sentence theCut $ \() ->
    Cases pressForm (Some genPress smallerPress) $ \press ->
      let (shift, pair) = change (pressChange press) (pressed press)
       in if telling pair shift
            then lying (fst (shapesFor (pressShapes press))) shift pair reason
            else pure Inapplicable

-- | Asks for the registration and judges it by the true displacement.
lying :: Maybe Drawings -> WholeTaxels -> Pair -> String -> Ask Verdict
lying shapes shift@(x, y) pair = asking shapes pair wanted fits
  where
    wanted = Registered Nothing (fromInteger x, fromInteger y) (True, True)
    fits got =
      registeredReason got == Nothing
        && registeredFixed got == (True, True)
        && near 0.5 shift (registeredBest got)

-- | The law of frames that share hardly more than the lattice.
latticeLaw :: Law ()
latticeLaw =
  law
    OnRegister
    "by-the-lattice"
    [SomeOp Register]
    "two frames of the alphabet's symbols are registered by their common lattice, to half a \
    \taxel, even if they have hardly anything in common"
    theCut
    $ \() -> Cases pressForm (Some genPress smallerPress) $ \press ->
      let (stated, shapes) = shapesFor (pressShapes press)
          cut = frameOf (16, 16) (lattice shapes (pressSeed press))
          step = if even (pressChange press) then (14, 0) else (0, 14)
          shift = moved step (pressError press)
       in lying
            stated
            shift
            (Pair (cut (0, 0)) (cut shift) step 3)
            "symbols stand 16 taxels apart along a row, and 20 along a column"

moved :: WholeTaxels -> WholeTaxels -> WholeTaxels
moved (x, y) (i, j) = (x + i, y + j)

-- | The source of these laws.
theCut :: String
theCut = "how the frames were cut; the protocol, register"

asking ::
  Maybe Drawings -> Pair -> Registered -> (Registered -> Bool) -> String -> Ask Verdict
asking shapes pair wanted fits reason =
  judge question (Right wanted) fits "the scene" reason <$> ask question
  where
    question = Register :? (shapes, pair)

near :: Double -> WholeTaxels -> Taxels -> Bool
near most (x, y) (x', y') = max (abs (fromInteger x - x')) (abs (fromInteger y - y')) <= most

-- | A law that pairs made from a press are refused with a reason. The function gives the pair, the
-- expected answer, and what else must fit; 'Nothing' if the law does not apply.
refusal ::
  String ->
  String ->
  String ->
  (FramePair -> Maybe (Pair, Registered, Registered -> Bool)) ->
  Law ()
refusal what sentence reason scene =
  law OnRegister what [SomeOp Register] sentence theCut $ \() ->
    Cases pressForm (Some genPress smallerPress) $ \press ->
      case scene press of
        Nothing -> pure Inapplicable
        Just (pair, wanted, fits) ->
          let same c = registeredReason c == registeredReason wanted
           in asking Nothing pair wanted (\c -> same c && fits c) reason

refusalLaws :: [Law ()]
refusalLaws =
  [ refusal
      "blank"
      "a pair in which one frame or both show nothing is refused: blank"
      "a frame of one grey value shows nothing"
      $ \press ->
        let (_, Pair a b step search) = pressed press
            change = pressChange press
            flat k = map (map (const (fromIntegral (k * 20))))
            pair = case change `mod` 3 of
              0 -> Pair (flat change a) b step search
              1 -> Pair a (flat change b) step search
              _ -> Pair (flat change a) (flat (change `div` 3) b) step search
         in Just (pair, unknown "blank" step (False, False), const True),
    refusal
      "one-axis"
      "a pair in which all edges are straight and parallel is refused: one-axis, with the \
      \displacement across the edges and the axis across them"
      "the relief is constant along the edges"
      oneAxis,
    refusal
      "periodic"
      "a pair whose relief repeats within the search along both axes is refused: ambiguous"
      "one period further both frames show the same again"
      $ \press ->
        let change = pressChange press
            periods = (period change, period (change `div` 3))
            period k = 4 + toInteger (k `mod` 3)
            phases = (pressSeed press `mod` 60, pressSeed press `div` 60 `mod` 60)
            (w, h) = pressSize press
            cut = frameOf (w + 8, h + 8) (periodic periods phases)
            step = pressStep press
            pair = Pair (cut (0, 0)) (cut (moved step (pressError press))) step 6
         in Just (pair, unknown "ambiguous" step (False, False), const True),
    refusal
      "no-overlap"
      "a pair that overlaps nowhere within the search is refused: no-overlap"
      "every displacement within the search is at least as long as the frame"
      $ \press ->
        let (_, Pair a b _ search) = pressed press
            (w, h) = pressSize press
            beyond = toInteger (pressChange press `mod` 7) + 3
            step = case pressChange press `mod` 4 of
              0 -> (w + beyond, 0)
              1 -> (negate w - beyond, 1)
              2 -> (0, h + beyond)
              _ -> (2, negate h - beyond)
         in Just (Pair a b step search, unknown "no-overlap" step (False, False), const True)
  ]
  where
    unknown reason (x, y) = Registered (Just reason) (fromInteger x, fromInteger y)

-- | A pair with up to three edges that both frames show at every displacement within the search.
oneAxis :: FramePair -> Maybe (Pair, Registered, Registered -> Bool)
oneAxis press
  -- Edges that cancel each other show nothing.
  | maximum profile < minimum profile + 4000 = Nothing
  | otherwise = Just (pair, Registered (Just "one-axis") at (across, not across), fits)
  where
    profile = [relief (t, t) | t <- [first' .. last']]
    change = pressChange press
    across = even change
    axis = if across then fst else snd
    (sx, sy) = pressStep press
    (ex, ey) = pressError press
    (x, y) = (sx + ex, sy + ey)
    -- The range that both frames see even if the second lies 3 taxels from its step.
    first' = axis (sx, sy) + 3
    last' = axis (pressSize press) - 4
    edges =
      [ (fromInteger (10 * first') + place k * fromInteger (last' - first') `div` 10, odd (sign k))
        | k <- [0 .. change `div` 2 `mod` 3]
      ]
    place k = pressSeed press `div` (97 ^ k) `mod` 97
    sign k = pressSeed press `div` (2 ^ k) `mod` 2
    relief = edged axis edges
    cut = frameOf (pressSize press) relief
    pair = Pair (cut (0, 0)) (cut (x, y)) (sx, sy) 3
    at = (fromInteger x, fromInteger y)
    fits got =
      registeredFixed got == (across, not across)
        && abs (axisOf (registeredBest got) - axisOf at) <= 0.5
    axisOf = if across then fst else snd

invalidLaw :: Law ()
invalidLaw =
  invalid OnRegister "refuses-what-is-invalid" Register $ \() ->
    [ SomeQuestion (Register :? (Nothing, pair))
      | pair <-
          [ Pair a (frameOf (16, 15) relief (8, 0)) (8, 0) 3,
            Pair (take 3 a) (take 3 b) (0, 0) 1,
            Pair (map (take 3) a) (map (take 3) b) (0, 0) 1,
            Pair [] [] (0, 0) 1,
            Pair [[]] [[]] (0, 0) 1,
            Pair (drop 1 a ++ [[1, 2]]) b (8, 0) 3,
            Pair a (drop 1 b ++ [replicate 16 (fullScale + 1)]) (8, 0) 3
          ]
    ]
      ++ [SomeQuestion (Register :? (Just shapes, Pair a b (8, 0) 3)) | shapes <- noShapes]
      ++ [rawWith plain "alphabet" other | other <- [Null, "#"]]
      ++ malformed plain
  where
    plain = Register :? (Nothing, Pair a b (8, 0) 3)
    relief = bumpy 1
    a = frameOf (16, 16) relief (0, 0)
    b = frameOf (16, 16) relief (8, 0)
