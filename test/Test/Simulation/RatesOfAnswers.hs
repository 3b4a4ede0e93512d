-- | The rates of right, wrong and refused answers.
module Test.Simulation.RatesOfAnswers (spec) where

import Control.Monad (forM_)
import Data.Bits (popCount, shiftL, (.&.), (.|.))
import Data.List (foldl')
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust)
import Data.Ratio ((%))
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.LinearCode.Punctured
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Polynomial (firstPrimitive)
import PraTactile.Rates.Damage (Damage (..))
import PraTactile.Rates.Formulas
import PraTactile.Rates.Noise
import PraTactile.Window
import PraTactile.Window.Distance
import Test.Code.Generators
import Test.Hspec
import Test.Paper

spec :: Spec
spec = do
  it "an error reaches a word as often as counting all errors says" $
    forM_ [(2, 6), (3, 4), (4, 4)] $ \(q, n) -> forM_ [0 .. n] $ \w -> forM_ [0 .. 2] $ \t -> do
      let p = 0.07
          vectors = mapM (const [0 .. q - 1]) [1 .. n]
          word = replicate w 1 ++ replicate (n - w) 0
          chance e = product [if x == 0 then 1 - p else p / fromIntegral (q - 1) | x <- e]
          counted =
            sum [chance e | e <- vectors, length (filter id (zipWith (/=) e word)) <= t] :: Double
      abs (reachProbability (BoundedDistance q n t p) w - counted) `shouldSatisfy` (< 1e-12)
  it "of many cells as often as cell by cell says, relatively, whatever powers leave doubles" $ do
    -- Of 4 symbols one is wrong with probability 3 / 48, one of three others.
    let apart n w =
          foldl'
            (\ds (near, far) -> zipWith (+) (map (near *) ds ++ [0]) (0 : map (far *) ds))
            [1]
            (replicate w (1, 47) ++ replicate (n - w) (45, 3))
        share n ds = fromRational (sum ds % 48 ^ n) :: Double
        close a b = abs (a - b) <= 1e-9 * b
        decoding n t = BoundedDistance 4 n t (1 / 16)
    forM_ [(600, 300, 100), (600, 0, 30), (40, 9, 3)] $ \(n, w, t) ->
      reachProbability (decoding n t) w `shouldSatisfy` close (share n (take (t + 1) (apart n w)))
    forM_ [(600, 300), (600, 30), (40, 3)] $ \(n, t) ->
      -- There is one window alone, so that none is mistaken for another.
      rateRefused (decodingRates (decoding n t) (Map.fromList [(0, 1), (fromIntegral n, 1)]))
        `shouldSatisfy` close (share n (drop (t + 1) (apart n 0)))
  it "of two symbols one is misread as often as a normal variable is beyond 1 / (sqrt 2 sigma)" $
    -- The upper tails of the normal distribution, from tables.
    forM_
      [ (0.1, 0.46017216272297101),
        (0.5, 0.30853753872598690),
        (1, 0.15865525393145705),
        (2, 0.02275013194817921),
        (3, 0.00134989803163010),
        (4, 0.00003167124183312),
        (5, 0.00000028665157188)
      ]
      $ \(x, tail') -> abs (errorRate 2 (1 / (x * sqrt 2)) - tail') `shouldSatisfy` (< 1e-14)
  it "of readings that are nothing but noise all but one in q are wrong" $
    forM_ [2, 3, 4, 16, 256] $ \q ->
      abs (errorRate q 1e9 - (1 - 1 / fromIntegral q)) `shouldSatisfy` (< 1e-8)
  it "on the paper's array: right, wrong and refused in %, as computed elsewhere" $
    forM_ figures $ \((side, t, p), figure) -> do
      weights <- weightsOf (Shape side side)
      let Rates a b c = decodingRates (BoundedDistance 4 (fromIntegral (side * side)) t p) weights
      map (100 *) [a, b, c] `shouldSatisfy` closeTo figure
  it "with 15 % erasures, by the window's distance and by that of the observed cells" $
    forM_ erasedFigures $ \((side, p), (byWindow, byObserved)) -> do
      code <- puncturedOf (Shape side side)
      let percent (Rates a b c) = map (100 *) [a, b, c]
      percent (erasedRates ByWindow 4 code (Damage p 0.15))
        `shouldSatisfy` (closeTo byWindow . take 1)
      percent (erasedRates ByObserved 4 code (Damage p 0.15)) `shouldSatisfy` closeTo byObserved
  it "without erasures the rates are those without erasures" $ do
    code <- puncturedOf (Shape 3 3)
    weights <- weightsOf (Shape 3 3)
    forM_ [ByWindow, ByObserved] $ \rule -> do
      let Rates a b c = erasedRates rule 4 code (Damage 0.05 0)
          Rates a' b' c' = decodingRates (BoundedDistance 4 9 1 0.05) weights
      maximum (map abs [a - a', b - b', c - c']) `shouldSatisfy` (< 1e-12)
  it "small rates are not lost beside large ones" $ do
    weights <- weightsOf (Shape 5 5)
    -- Mostly those of 8 errors among 25 cells: 1081575 * 0.0006^8 * 0.9994^17, by hand 1.799e-20.
    let Rates _ wrong refused = decodingRates (BoundedDistance 4 25 7 0.0006) weights
    abs (refused / 1.799e-20 - 1) `shouldSatisfy` (< 0.01)
    (wrong, wrong < refused) `shouldSatisfy` (\(w, less) -> w > 0 && less)
  it "the rates are the decoder's: every position, set of cells and pattern of errors" $ do
    -- The last of the binary windows has fewer cells than a position needs, but zeros in it are
    -- one position; so have parts of the others.
    binary <-
      right (firstPrimitive 4)
        >>= right . folded Diagonal (Shape 3 5) ::
        IO (PseudorandomArray GF2)
    forM_ [Shape 2 2, Shape 2 3, Shape 1 3] $ asDecided binary
    ternary <-
      right (firstPrimitive 2)
        >>= right . folded Diagonal (Shape 1 8) ::
        IO (PseudorandomArray GF3)
    forM_ [Shape 1 2, Shape 1 4] $ asDecided ternary
    quaternary <-
      right (firstPrimitive 2)
        >>= right . folded Diagonal (Shape 3 5) ::
        IO (PseudorandomArray GF4)
    forM_ [Shape 2 2, Shape 1 4] $ asDecided quaternary
  it "punctured codes: every set of observed cells is in the class that its words say" $
    forM_
      [ (5, [3, 5, 6, 9, 10, 17, 31, 31]),
        (6, [7, 7, 56, 56, 21, 21, 42, 42, 63, 63]),
        (4, [1]),
        (9, [k * k `mod` 512 | k <- [3 .. 40]])
      ]
      $ \(n, supports) -> do
        let classOf seen =
              let weights = map (popCount . (.&. seen)) supports
                  least = minimum weights
                  lone = least == 0 && length (filter (== 0) weights) == 1
               in ((popCount seen, least, lone), (1, Map.fromListWith (+) [(w, 1) | w <- weights]))
            counted =
              Map.fromListWith
                (\(k, a) (k', a') -> (k + k', Map.unionWith (+) a a'))
                (map classOf [0 .. 2 ^ n - 1 :: Int])
            found code = Map.fromList (map kept (puncturedClasses code))
            kept c =
              ( (classCells c, classDistance c, classLoneZero c),
                (classSets c, Map.fromList (classWeights c))
              )
        fmap found (punctured n supports)
          `shouldBe` Just (counted :: Map.Map (Int, Int, Bool) (Int, Map.Map Int Int))
  it "punctured codes: too many cells or words are refused" $ do
    punctured (mostErasedCells + 1) [1] `shouldBe` Nothing
    -- 2^25 sets of 2^8 words each are 2^33; they are not gone through here.
    isJust (punctured 25 (map (2 *) [1 .. 256])) `shouldBe` True
    punctured mostErasedCells (map (2 *) [1 .. 257]) `shouldBe` Nothing
    punctured 3 [] `shouldBe` Nothing
  where
    -- Side, radius, error rate; and what is right, wrong and refused in %: by a program in another
    -- language, which makes the array from its definition and adds up, over all pairs of positions,
    -- how likely an error is to come near the one from the other.
    figures :: [((Natural, Int, Double), [Double])]
    figures =
      [ ((2, 0, 0.006), [97.6215137296, 2.3691588732611764, 0.00932739713882353]),
        ((3, 1, 0.006), [99.87398020115688, 6.495009860547454e-05, 0.1259548487445105]),
        ((3, 1, 0.05), [92.87886038046875, 0.03003893318289652, 7.091100686348353]),
        ((4, 4, 0.05), [99.91426883409552, 0.0003891612986576278, 0.0853420046058222]),
        ((4, 4, 0.1), [98.29960017221205, 0.00826659743291069, 1.6921332303550394]),
        ((5, 7, 0.1), [99.77386884272202, 1.3924013450917675e-06, 0.22612976487663644])
      ]
    -- Side and error rate; what is right in % to the window's distance, and right, wrong and
    -- refused in % to that of the cells observed: by the same program, which visits every set of
    -- cells.
    erasedFigures :: [((Natural, Double), ([Double], [Double]))]
    erasedFigures =
      [ ( (2, 0.05),
          ([42.51773531640624], [42.51773531640624, 9.644917567187532, 47.83734711640623])
        ),
        ( (3, 0.006),
          ([95.09110105273943], [98.16767825593125, 0.05567220674416963, 1.7766495373245736])
        ),
        ( (3, 0.05),
          ([82.18601170166926], [85.46314686014013, 0.6938291103426183, 13.843024029517256])
        ),
        ( (4, 0.02),
          ([99.68510618441823], [99.84944315386728, 0.000524842223903143, 0.150032003908818])
        ),
        ( (4, 0.1),
          ([90.4736777422763], [91.61514715524709, 0.030471883180872943, 8.354380961572037])
        )
      ]
    closeTo figure found =
      length figure == length found && and (zipWith (\x y -> abs (x - y) <= 1e-9 * y) found figure)

-- | The rates beside what 'nearest' makes of everything that can happen, each with its probability.
asDecided :: KnownField k => PseudorandomArray k -> Shape -> Expectation
asDecided array size = do
  m <- right (rectangle size)
  codebook <- right (buildCodebook (ArrayOn Torus array) m)
  let n = maskSize m
      q = fieldOrder array
      Shape high wide = arrayShape array
      places =
        [ (at, content)
          | r <- [0 .. high - 1],
            c <- [0 .. wide - 1],
            let at = Position r c,
            Just content <- [windowAt (ArrayOn Torus array) m at]
        ]
      supports = map (supportOf . snd) places
  code <- maybe (expectationFailure "nothing" >> fail "nothing") pure (punctured n supports)
  decided <-
    sequence
      [ do
          p' <- right (patch (chunked (fromIntegral (columns size)) cells))
          pure (decisionOutcome (nearest codebook Guaranteed p'), cells)
        | cells <- mapM (const (Nothing : map Just elements)) [1 .. n]
      ]
  let p = 0.07
      s = 0.2
      chance content cells = product (zipWith cellChance content cells)
      cellChance _ Nothing = s
      cellChance x (Just y) =
        (1 - s) * (if x == y then 1 - p else p / fromIntegral (q - 1)) :: Double
      total wanted =
        sum
          [ chance content cells
            | (outcome, cells) <- decided,
              (at, content) <- places,
              wanted (located at outcome)
          ]
          / fromIntegral (length places)
      located at outcome = case outcome of Unique found _ -> Just (found == at); _ -> Nothing
      Rates a b c = erasedRates ByObserved q code (Damage p s)
      differences = zipWith (-) [a, b, c] (map (total . (==)) [Just True, Just False, Nothing])
  (size, length differences, maximum (map abs differences))
    `shouldSatisfy` (\(_, k, d) -> k == 3 && d < 1e-12)
  where
    chunked k xs = case splitAt k xs of
      ([], _) -> []
      (first, others) -> first : chunked k others

weightsOf :: Shape -> IO (Map.Map Natural Natural)
weightsOf size = do
  array <- paperArray
  m <- right (rectangle size)
  right (weightEnumerator array m)

puncturedOf :: Shape -> IO Punctured
puncturedOf size = do
  array <- paperArray
  m <- right (rectangle size)
  maybe (expectationFailure "nothing" >> fail "nothing") pure $
    punctured
      (maskSize m)
      [ supportOf content
        | r <- [0 .. 14],
          c <- [0 .. 16],
          Just content <- [windowAt (ArrayOn Torus array) m (Position r c)]
      ]

-- | Bit i for the cell i, if it is not zero.
supportOf :: KnownField k => [GF k] -> Int
supportOf content = foldl' (.|.) 0 [1 `shiftL` i | (i, a) <- zip [0 ..] content, a /= 0]
