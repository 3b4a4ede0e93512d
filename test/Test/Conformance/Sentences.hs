-- | What impostors say of themselves is what they do: those of the code under small profiles, where
-- the right answers are known; those of touch to the answers of somebody who always gives the same
-- ones, and to what is asked of them; those of opening to every profile of the kind that they take,
-- or do not.
module Test.Conformance.Sentences (spec) where

import Control.Monad.IO.Class (liftIO)
import Control.Monad.Trans.Except (runExceptT)
import Data.Either (isLeft, isRight)
import Data.Foldable (for_)
import Data.IORef
import Data.List (elemIndex, find, nub, nubBy, sort)
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Shape (Shape), area)
import PraTactile.Conformance
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Law (Stage (..), codeStages)
import PraTactile.Profile (Profile (..))
import qualified Test.Conformance.Sentences.Arrays as Arrays
import qualified Test.Conformance.Sentences.Chances as Chances
import qualified Test.Conformance.Sentences.Fields as Fields
import qualified Test.Conformance.Sentences.Places as Places
import qualified Test.Conformance.Sentences.Reading as Reading
import Test.Hspec

spec :: Spec
spec = do
  openingSpec
  logarithmSpec
  codeSpec
  segmentSpec
  registerSpec
  stitchSpec

-- | The touch of the impostor of that name, made of this one.
made :: String -> Touch -> IO Touch
made name right' = do
  one <- maybe (fail ("no impostor " ++ name)) pure (find ((== name) . impostorName) impostors)
  pure (touch (impostorMake one library {touch = right'}))

namesOn :: Stage -> [String]
namesOn stage = [impostorName one | one <- impostors, impostorTouches one == [stage]]

answered :: Wire a -> IO a
answered wire = runExceptT wire >>= either (fail . show . refusalReason) pure

-- | Of each impostor of the code that takes all possible profiles something is said, once.
codeSpec :: Spec
codeSpec = do
  it "of the code there is a sentence for each" $
    sort
      ( map fst ofLogarithms ++ Reading.names ++ Fields.names ++ Arrays.names
          ++ Places.names
          ++ Chances.names
      )
      `shouldBe` sort
        [ impostorName one
          | one <- impostors,
            all (`elem` drop 2 codeStages) (impostorTouches one)
        ]
  Reading.spec
  Fields.spec
  Arrays.spec
  Places.spec
  Chances.spec

-- | The logarithms of those that err in logarithms alone, of every element of every default field.
logarithmSpec :: Spec
logarithmSpec = describe "of logarithms" $
  for_ ofLogarithms $ \(name, says) -> it name $ do
    one <- maybe (fail ("no impostor " ++ name)) pure (find ((== name) . impostorName) impostors)
    for_ (fields defaultProfiles) $ \p -> do
      right' <- answered (open library p)
      wrong <- answered (open (impostorMake one library) p)
      let q = profileOrder p
      for_ [0 .. q - 1] $ \a -> do
        let powersOf g = mapM (answered . power right' g . toInteger) [0 .. q - 2]
        powers <- mapM powersOf [0 .. q - 1]
        came <- runExceptT (logarithm wrong a)
        (q, a, either (const Nothing) Just came) `shouldBe` (q, a, says p powers a)
  where
    fields = nubBy (\p p' -> modulusOf p == modulusOf p') . filter ((<= 9) . profileOrder) . map snd
    modulusOf p = (profileOrder p, profileModulus p)

-- | What each says, given the powers of every element from 0 on.
ofLogarithms :: [(String, Profile -> [[Natural]] -> Natural -> Maybe Natural)]
ofLogarithms =
  [ ( "takes-logarithms-to-the-root",
      \p powers a -> if a == 0 then Nothing else to (root p) powers a
    ),
    ( "counts-logarithms-from-one",
      \p powers a ->
        if a == 1 then Just (profileOrder p - 1) else to (least powers) powers a
    ),
    ( "has-a-logarithm-of-zero",
      \p powers a -> if a == 0 then Just (profileOrder p - 1) else to (least powers) powers a
    ),
    ("takes-the-largest-primitive-element", \_ powers a -> to (largest powers) powers a)
  ]
  where
    to g powers a = fromIntegral <$> elemIndex a (powers !! fromIntegral g)
    primitives powers = [g | (g, those) <- zip [0 :: Natural ..] powers, g > 0, nub those == those]
    least = minimum . primitives
    largest = maximum . primitives
    root p = case profileModulus p of
      [c, 1] -> (profileOrder p - c) `mod` profileOrder p
      _ -> characteristicOf p
    characteristicOf p = head [l | l <- [2 ..], profileOrder p `mod` l == 0]

-- | Each takes impossible profiles of a kind, or refuses possible ones: every default profile is
-- made one of that kind.
openingSpec :: Spec
openingSpec = describe "of opening" $ do
  it "there is a sentence for each, and it holds of the profiles that are opened" $
    sort (map fst taken ++ map fst refused) `shouldBe` sort (namesOn OnProfile)
  for_ taken $ \(name, spoilt) -> it name $ do
    found <-
      sequence
        [ (,,) name' (shown p') <$> opens name p'
          | (name', p) <- defaultProfiles,
            p' <- spoilt p,
            isLeft (known p')
        ]
    found `shouldSatisfy` (not . null)
    filter (\(_, _, came) -> not came) found `shouldBe` []
  for_ refused $ \(name, (right', wrong)) -> it name $
    for_ defaultProfiles $ \(name', p) -> do
      let possible = filter (not . isLeft . known)
      mapM (opens name) (possible (right' p)) >>= (`shouldSatisfy` and)
      these <- mapM (opens name) (possible (wrong p))
      (name', or these) `shouldBe` (name', False)
  where
    shown p' = (profilePolynomial p', profileModulus p', profileState p', profileShape p')
    opens name p = do
      one <- maybe (fail ("no impostor " ++ name)) pure (find ((== name) . impostorName) impostors)
      isRight <$> runExceptT (open (impostorMake one library) p)
    -- Over the field of another modulus the polynomial need not be primitive.
    usual p = profileModulus p `notElem` [[1, 0, 1], [1, 0, 1, 1]]
    degree p = length (profilePolynomial p) - 1
    led by xs = take (length xs - 1) xs ++ [by]
    modulo p = map (+ profileOrder p)
    taken =
      [ ("reads-the-order-off-the-modulus", \p -> [p {profileOrder = q} | q <- [1, 6, 10]]),
        ( "takes-the-usual-modulus-for-another-degree",
          \p -> [p {profileModulus = m} | usual p, m <- [profileModulus p ++ [1], []]]
        ),
        ( "takes-the-usual-modulus-for-a-reducible-one",
          \p ->
            [ p {profileModulus = replicate (length (profileModulus p) - 1) 0 ++ [1]}
              | usual p
            ]
        ),
        ("makes-the-modulus-monic", \p -> [p {profileModulus = led 2 (profileModulus p)}]),
        ("reduces-the-modulus", \p -> [p {profileModulus = modulo p (profileModulus p)}]),
        ( "makes-the-polynomial-monic",
          \p -> [p {profilePolynomial = led a (profilePolynomial p)} | a <- [0, profileOrder p]]
        ),
        ( "accepts-a-polynomial-that-is-not-primitive",
          \p -> [p {profilePolynomial = 1 : replicate (degree p - 1) 0 ++ [1]}]
        ),
        ( "reduces-the-polynomial",
          \p -> [p {profilePolynomial = modulo p (profilePolynomial p)}]
        ),
        ("accepts-the-state-of-zeros", \p -> [p {profileState = replicate (degree p) 0}]),
        ( "fills-up-the-state",
          \p ->
            [ p {profileState = state}
              | state <- [[], [1], replicate (degree p - 1) 0, profileState p ++ [1, 0]]
            ]
        ),
        ( "reduces-the-state",
          \p ->
            [ p {profileState = state}
              | state <- [modulo p (profileState p), replicate (degree p) (profileOrder p)]
            ]
        ),
        ( "accepts-any-shape",
          \p -> let Shape h w = profileShape p in [p {profileShape = Shape (h + 1) w}]
        ),
        ( "accepts-sides-that-are-not-coprime",
          \p ->
            [ p {profileShape = Shape d (cells `div` d), profileFolding = Diagonal}
              | let cells = area (profileShape p),
                d <- [2 .. 20],
                cells `mod` (d * d) == 0
            ]
        ),
        ( "accepts-the-window-without-cells",
          \p -> [p {profileWindow = window} | window <- [Shape 0 2, Shape 2 0, Shape 0 0]]
        )
      ]
    -- What is opened all the same, and what is refused.
    refused =
      [ ( "demands-that-windows-differ",
          ( \p -> [p {profileWindow = Shape 1 (fromIntegral (degree p))}],
            \p -> [p {profileWindow = Shape 1 1} | profileOrder p <= area (profileShape p)]
          )
        ),
        ( "demands-a-primitive-modulus",
          ( \p -> [p | profileModulus p /= [1, 0, 1]],
            \p -> [p {profileModulus = [1, 0, 1]} | profileOrder p == 9]
          )
        ),
        ( "demands-the-usual-state",
          ( \p -> [p {profileState = replicate (degree p - 1) 0 ++ [1]}],
            \p -> [p {profileState = 1 : replicate (degree p - 1) 0} | degree p > 1]
          )
        ),
        ( "demands-a-diagonal-fold",
          ( \p -> [p | profileFolding p == Diagonal],
            \p -> [p {profileFolding = RowMajor}]
          )
        )
      ]

segmentSpec :: Spec
segmentSpec = describe "of finding symbols" $ do
  it "there is a sentence for each, and it holds of what is told" $
    sort (map fst answers ++ map fst questions) `shouldBe` sort (namesOn OnSegment)
  for_ answers $ \(name, cases) -> it name $
    for_ cases $ \(rows, right', wrong) -> do
      with <- made name noTouch {segment = const (pure (map symbol right'))}
      found <- answered (segment with rows)
      map plain found `shouldBe` wrong
  for_ questions $ \(name, cases) -> it name $
    for_ cases $ \(rows, other) -> do
      seen <- newIORef []
      with <- made name noTouch {segment = \given -> [] <$ liftIO (writeIORef seen given)}
      _ <- answered (segment with rows)
      readIORef seen `shouldReturn` other
  where
    symbol (x, y, a) = Symbol (x, y) a
    plain (Symbol (x, y) a) = (x, y, a)
    some = [(10, 20, 5), (27.5, 41, 93), (3, 4, 178)]
    even' = replicate 8 (replicate 6 7)
    answers =
      [ ( "tells-corners-for-centres",
          [(even', some, [(6.5, 14.5, 5), (24, 35.5, 93), (-0.5, -1.5, 178)])]
        ),
        ("tells-rows-for-columns", [(even', some, [(20, 10, 5), (41, 27.5, 93), (4, 3, 178)])]),
        ("counts-pixels-from-one", [(even', some, [(11, 21, 5), (28.5, 42, 93), (4, 5, 178)])]),
        ( "puts-symbols-on-a-lattice",
          [(even', some, [(10, 20, 5), (26, 40, 93), (10, 0, 178)]), (even', [], [])]
        ),
        ( "calls-upright-symbols-lying",
          [(even', some, [(10, 20, 95), (27.5, 41, 183), (3, 4, 268)])]
        ),
        ("sees-every-symbol-upright", [(even', some, [(10, 20, 0), (27.5, 41, 0), (3, 4, 0)])]),
        ( "knows-four-directions",
          (even', some, [(10, 20, 0), (27.5, 41, 90), (3, 4, 180)]) :
            [ (even', [(1, 2, a)], [(1, 2, nearest')])
              | a <- [0, 0.25 .. 359.75],
                let quarters = [90 * k | k <- [0 .. 4], abs (a - 90 * k) < 45],
                nearest' <- quarters
            ]
        ),
        ( "finds-upright-symbols-only",
          [ (even', some, [(10, 20, 5), (3, 4, 178)]),
            ( even',
              [(0, 0, a) | a <- [0, 44, 44.5, 45.5, 46, 90, 134, 134.5, 135.5, 136, 179]],
              [(0, 0, a) | a <- [0, 44, 44.5, 135.5, 136, 179]]
            )
          ]
        ),
        ( "overlooks-the-last-symbol",
          [(even', some, [(10, 20, 5), (27.5, 41, 93)]), (even', [], [])]
        ),
        ( "takes-cut-symbols-for-whole",
          [ (even', some, some),
            ([[7, 7], [7, 9]], some, some),
            ([[7, 7], [9, 7]], some, some ++ [(1, 6, 0)])
          ]
        ),
        ("sees-a-symbol-in-nothing", [(even', some, some), (even', [], [(0, 4, 0)])])
      ]
    questions =
      [ ( "has-a-threshold-of-its-own",
          [ ([[13999, 14001], [20000, 0]], [[13999, 14001], [20000, 0]]),
            ([[14000, 14001], [20001, 65535]], [[8000, 20000], [20000, 20000]]),
            -- Too large for a grey value, which is refused.
            ([[14000, 14001], [20001, 65536]], [[8000, 20000], [20000, 65536]])
          ]
        ),
        ( "segments-ragged-rows",
          [([[1, 2], [], [4, 5, 6]], [[1, 2, 0], [0, 0, 0], [4, 5, 6]]), ([], [])]
        )
      ]

registerSpec :: Spec
registerSpec = describe "of registering frames" $ do
  it "there is a sentence for each, and it holds of what is told" $
    sort (map fst answers ++ map fst questions ++ ["compares-grey-values"])
      `shouldBe` sort (namesOn OnRegister)
  for_ answers $ \(name, cases) -> it name $
    for_ cases $ \(right', wrong) -> do
      with <- made name noTouch {register = const (pure right')}
      answered (register with (Pair flat flat (8, -1) 3)) `shouldReturn` wrong
  for_ questions $ \(name, cases) -> it name $
    for_ cases $ \(pair, other) -> do
      seen <- newIORef Nothing
      with <-
        made name noTouch {register = \given -> found <$ liftIO (writeIORef seen (Just given))}
      _ <- answered (register with pair)
      readIORef seen `shouldReturn` Just other
  it "compares-grey-values" $ do
    -- The second shows what the first does, two taxels further right and one down.
    let scene = [[10 * x * x + 7 * y * y * y | x <- [0 .. 9]] | y <- [0 .. 9]]
        cut x y = [take 5 (drop x row) | row <- take 5 (drop y scene)]
        asked' = Pair (cut 2 2) (cut 4 3)
        told reason pair = do
          let right' = found {registeredReason = reason}
          with <- made "compares-grey-values" noTouch {register = const (pure right')}
          registeredBest <$> answered (register with pair)
    told Nothing (asked' (2, 1) 0) `shouldReturn` (2, 1)
    told Nothing (asked' (1, 2) 2) `shouldReturn` (2, 1)
    told Nothing (asked' (4, 1) 1) `shouldReturn` (3, 1)
    -- Brighter, and searched as far as frames do not meet, of which nothing is the difference.
    let bright = map (map (+ 3)) (cut 4 3)
    told Nothing (Pair (cut 2 2) bright (3, 1) 4) `shouldReturn` (2, 1)
    told (Just "ambiguous") (asked' (1, 2) 2) `shouldReturn` registeredBest found
  where
    flat = replicate 4 (replicate 4 1)
    found = Registered Nothing (7, 2) (True, True)
    axis = Registered (Just "one-axis") (7, 2) (True, False)
    for' reason = Registered (Just reason) (7, 2) (False, False)
    unclear = for' "ambiguous"
    answers =
      [ ("registers-x-backwards", [(found, found {registeredBest = (9, 2)})]),
        ("registers-rows-for-columns", [(found, found {registeredBest = (2, 7)})]),
        ("registers-one-off", [(found, found {registeredBest = (8, 2)})]),
        ("registers-to-the-middle", [(found, found {registeredBest = (7.5, 0.5)})]),
        ("trusts-the-step", [(found, found {registeredBest = (8, -1)})]),
        ("registers-whatever-comes", [(found, found), (axis, found), (unclear, found)]),
        ( "calls-every-refusal-ambiguous",
          [ (found, found),
            (axis, axis {registeredReason = Just "ambiguous"}),
            (for' "blank", unclear),
            (for' "no-overlap", unclear)
          ]
        ),
        ( "calls-the-ambiguous-blank",
          [(unclear, for' "blank"), (axis, axis), (found, found)]
            ++ [(for' "no-overlap", for' "no-overlap")]
        ),
        ( "names-the-other-axis",
          [(axis, axis {registeredFixed = (False, True)}), (unclear, unclear), (found, found)]
        )
      ]
    questions =
      [ ( "searches-one-taxel",
          [(asking (8, 0) k, asking (8, 0) l) | (k, l) <- [(0, 0), (1, 1), (2, 1), (5, 1)]]
        ),
        ( "steps-forwards-only",
          [(asking (-8, 3) 2, asking (8, 3) 2), (asking (1, -4) 2, asking (1, 4) 2)]
        ),
        ( "takes-the-least-frame",
          [ ( Pair [[1, 2, 3], [4, 5, 6]] [[7, 8], [9, 10], [11, 12]] (0, 0) 1,
              Pair [[1, 2], [4, 5]] [[7, 8], [9, 10]] (0, 0) 1
            ),
            (asking (8, 0) 2, asking (8, 0) 2)
          ]
        )
      ]
    asking = Pair flat flat

stitchSpec :: Spec
stitchSpec = describe "of putting frames together" $ do
  it "there is a sentence for each, and it holds of what is told" $
    sort (map fst answers ++ [name | (name, _, _) <- questions]) `shouldBe` sort (namesOn OnStitch)
  for_ answers $ \(name, wrong) -> it name $ do
    with <- made name noTouch {stitch = \_ frames -> pure (take (length frames) right')}
    answered (stitch with 2 placed) `shouldReturn` wrong
    none <- made name noTouch {stitch = \_ _ -> pure []}
    answered (stitch none 2 []) `shouldReturn` []
  for_ questions $ \(name, given, other) -> it name $ do
    seen <- newIORef []
    with <-
      made name noTouch {stitch = \_ frames -> [] <$ liftIO (writeIORef seen frames)}
    _ <- answered (stitch with 2 given)
    readIORef seen `shouldReturn` other
  where
    frame = replicate 2 (replicate 2 5)
    placed = [Placed frame (20, 0), Placed frame (0, 40), Placed frame (-10, 40)]
    right' = [(1, 2), (-0.5, 0.25), (0, -1)]
    answers =
      [ ("stitches-nothing", [(0, 0), (0, 0), (0, 0)]),
        ("corrects-backwards", [(-1, -2), (0.5, -0.25), (0, 1)]),
        ("corrects-rows-for-columns", [(2, 1), (0.25, -0.5), (-1, 0)]),
        ("corrects-along-rows", [(1, 0), (-0.5, 0), (0, 0)]),
        ("stretches-the-robot", [(2, 2), (-0.5, 2.25), (-0.5, 1)]),
        ("leaves-the-last-frame", [(1, 2), (-0.5, 0.25), (0, 0)]),
        -- The third lies left of the second.
        ("tells-frames-row-by-row", [(1, 2), (0, -1), (-0.5, 0.25)])
      ]
    questions =
      [ ( "counts-places-from-zero",
          [Placed frame (-3, 4), Placed frame (5, -6)],
          [Placed frame (3, 4), Placed frame (5, 6)]
        ),
        ( "takes-bright-for-saturated",
          [Placed [[0, 21844], [21845, 21846]] (1, 1), Placed [[65535]] (0, 0)],
          [Placed [[0, 21844], [21845, 21845]] (1, 1), Placed [[21845]] (0, 0)]
        ),
        ( "stitches-frames-of-any-size",
          [Placed [[1, 2, 3], [4, 5, 6]] (0, 0), Placed [[7, 8], [9, 10], [11, 12]] (1, 0)],
          [Placed [[1, 2], [4, 5]] (0, 0), Placed [[7, 8], [9, 10]] (1, 0)]
        )
      ]
