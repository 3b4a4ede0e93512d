{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE TypeApplications #-}

-- | This library's side of each comparison. Every entry prepares its input once and then measures
-- on each request. A program with the same name in @bench/peers@ does the same work.
module Bench.Ours
  ( ours,
  )
where

import Bench.Clock
import Bench.Input
import Bench.Locating (locating)
import Bench.Packing (packing)
import Control.Exception (evaluate)
import Control.Parallel.Strategies (parBuffer, rseq, withStrategy)
import qualified Data.ByteString as Bytes
import Data.List (intercalate)
import Data.Maybe (catMaybes)
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Classification.Shipped (shippedAlphabet, shippedReader)
import PraTactile.Evaluate
import PraTactile.Explore (Turns (..), halfTurns, standardRegionSize)
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Image.Pgm (decodePgm, pgmIntensity)
import PraTactile.Object.Canonical (canonicalPlacement)
import PraTactile.Object.Placement (Placement, laidFaces)
import PraTactile.Polynomial
import PraTactile.Profile (canonicalProfile, withProfile)
import PraTactile.Recognise
import PraTactile.Registration (compositeOf, standardRegistration)
import PraTactile.Relief (relief)
import PraTactile.Sensor (standardSensor)
import PraTactile.Sequence
import PraTactile.Window
import PraTactile.Window.Proof

-- | The measurements by name. The outer action prepares.
ours :: [(String, IO (IO Measurement))]
ours =
  [ ("products-gf4", products (Proxy @GF4)),
    ("products-gf256", products (Proxy @GF256)),
    ("products-run-time", sure (withField 2 [1, 1, 1] products)),
    ("sequence-gf4-12", sequenceOf [2, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1]),
    ("sequence-gf4-12-dense", sequenceOf [2, 1, 3, 3, 3, 1, 2, 3, 1, 3, 1, 3, 1]),
    ("proof-gf4", wholeProof (rectangle (Shape 3 4))),
    ("proof-gf4-mask", wholeProof (maskFromDrawing "####./.####/####.")),
    ("rank-gf2-8x8", rankProof (Shape 255 ((2 ^ (64 :: Int) - 1) `div` 255)) (Shape 8 8)),
    ("rank-gf2-32x2", rankProof (Shape (2 ^ (32 :: Int) - 1) (2 ^ (32 :: Int) + 1)) (Shape 32 2)),
    ("cell-gf2-64", cells (firstPrimitive 64 :: Either PolynomialError (Primitive GF2))),
    ("cell-gf3-40", cells (firstPrimitive 40 :: Either PolynomialError (Primitive GF3))),
    ("cell-gf4-32", cells (firstPrimitive 32 :: Either PolynomialError (Primitive GF4))),
    ( "cell-gf256-8",
      cells
        ( Right (primitiveOf [232, 32, 17, 159, 27, 1, 174, 189, 1]) ::
            Either
              PolynomialError
              (Primitive GF256)
        )
    ),
    ("first-gf2-128", firstOf (Proxy @GF2) 128),
    ("first-gf3-20", firstOf (Proxy @GF3) 20),
    ("quartics-gf4", quartics),
    ("decode", decode),
    ("evaluate-100", evaluate100)
  ]
    ++ locating
    ++ packing

products :: forall k. KnownField k => Proxy k -> IO (IO Measurement)
products k = do
  x <- evaluate (scrambled k 2654435761)
  y <- evaluate (scrambled k 2246822519)
  pure $ do
    (seconds, z) <- timed (uncurry (Primitive.zipWith (*))) (x, y)
    let total = Primitive.foldl' (\acc a -> acc + toCode a) 0 z
    pure
      ( Measurement
          (fromIntegral (Primitive.length x) / seconds)
          (PerSecond "products")
          (show total)
      )

primitiveOf :: KnownField k => [Natural] -> Primitive k
primitiveOf codes = sure (checkPrimitive (sure (polynomialFromCodes codes)))

sequenceOf :: [Natural] -> IO (IO Measurement)
sequenceOf codes = do
  h <- evaluate (primitiveOf codes :: Primitive GF4)
  pure $ do
    (seconds, s) <- timed (sequenceVector h (canonicalState h)) 16777215
    let weighted = Primitive.ifoldl' (\acc i a -> acc + i `mod` 257 * toCode a) 0 s
    pure
      ( Measurement
          (fromIntegral (Primitive.length s) / seconds)
          (PerSecond "symbols")
          (show weighted)
      )

wholeProof :: Either WindowError Mask -> IO (IO Measurement)
wholeProof window = do
  h <- evaluate (primitiveOf [2, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1] :: Primitive GF4)
  mask <- evaluate (sure window)
  let foldAndProve g =
        let array = sure (fold Diagonal (Shape 63 266305) g (canonicalState g))
         in distinct (prove (naturally array) mask)
  pure $ do
    (seconds, found) <- timed foldAndProve h
    pure (Measurement seconds Seconds (maybe "undecided" show found))
  where
    distinct outcome =
      let (verdict, _) = sure outcome
       in if proved verdict && enumeration verdict == Just True
            then distinctWindows verdict
            else Nothing

rankProof :: Shape -> Shape -> IO (IO Measurement)
rankProof shape window = do
  h <- evaluate (sure (firstPrimitive 64) :: Primitive GF2)
  array <- evaluate (sure (fold Diagonal shape h (canonicalState h)))
  mask <- evaluate (sure (rectangle window))
  pure $ do
    (seconds, verdict) <-
      timed
        (\a -> let (v, _) = sure (prove (naturally a) mask) in if proved v then rank v else Nothing)
        array
    pure (Measurement seconds Seconds (show verdict))

-- | The mean time over 256 cells all over an array of one row, the most general shape.
cells :: KnownField k => Either PolynomialError (Primitive k) -> IO (IO Measurement)
cells found = do
  h <- evaluate (sure found)
  array <- evaluate (sure (fold RowMajor (Shape 1 (period h)) h (canonicalState h)))
  let places = [Position 0 (i * 0x9E3779B97F4A7C15 `mod` period h) | i <- [1 .. 256]]
  pure $ do
    (seconds, _) <- timedEach (cellAt array) zero places
    pure (Measurement seconds Seconds (show (sum (map (toCode . cellAt array) places))))

polynomialText :: Primitive k -> String
polynomialText = intercalate "," . map (show . toCode) . coefficients . primitivePolynomial

firstOf :: forall k. KnownField k => Proxy k -> Natural -> IO (IO Measurement)
firstOf _ n = pure $ do
  (seconds, h) <- timed (\m -> sure (firstPrimitive m) :: Primitive k) n
  pure (Measurement seconds Seconds (polynomialText h))

quartics :: IO (IO Measurement)
quartics = pure $ do
  (seconds, found) <-
    timed (\n -> let hs = sure (primitivePolynomials n) :: [Primitive GF4] in length hs `seq` hs) 4
  pure (Measurement seconds Seconds (unwords (map polynomialText found)))

-- | Runs a benchmark of touch with the paper's array, placement and recogniser, as the command
-- line does.
withPaper :: (forall k. KnownField k => PseudorandomArray k -> Placement -> Recogniser k -> r) -> r
withPaper use = sure (withProfile canonicalProfile prepared)
  where
    prepared array mask =
      use
        array
        layout
        (sure (recogniser (naturally array) mask layout (sure (shippedReader 4))))
    layout = sure canonicalPlacement

-- | The time to recognise the composite of the worked example.
decode :: IO (IO Measurement)
decode = do
  image <- pgmIntensity . sure . decodePgm <$> Bytes.readFile "data/worked-example/composite.pgm"
  composite <- evaluate (compositeOf image)
  pure $
    withPaper $ \_ _ reader -> do
      (seconds, answer) <- timed (either (const "misfit") answerText . recognise reader) composite
      pure (Measurement seconds Seconds answer)
  where
    answerText recognition = case recognisedAnswer recognition of
      Right (Found found) ->
        text (show (foundOrientation found, windowPosition (foundWindow found)))
      Right (Several _ positions) -> text (show positions)
      Left refusal -> text (refusalName refusal)
    text t = length t `seq` t

-- | The time of 100 simulated presses, each decoded with and without stitching, on the cores given
-- to the run-time system.
evaluate100 :: IO (IO Measurement)
evaluate100 = pure $
  withPaper $ \array layout reader -> do
    let alphabet = sure (shippedAlphabet 4)
        faces =
          sure
            (traverse (\face -> (,) face <$> relief array layout alphabet face) (laidFaces layout))
        results seed =
          let presses = catMaybes (take 100 (trials explored faces seed))
              counts = tally (map withStitching (run presses))
           in tallyWrong counts `seq` counts
        explored = exploration standardSensor (AmongTurns halfTurns) standardRegionSize
        run =
          withStrategy (parBuffer 64 rseq)
            . map (forced . runTrial standardTolerance reader standardRegistration)
        forced r = withStitching r `seq` withoutStitching r `seq` r
    (seconds, counts) <- timed results 1
    let refused = sum (tallyRefused counts)
    pure
      ( Measurement
          seconds
          Seconds
          ( unwords
              [ "right",
                show (tallyRight counts),
                "wrong",
                show (tallyWrong counts),
                "refused",
                show refused
              ]
          )
      )
