-- | What a frame tells of the lattice under it, against its definition: expectation and
-- maximisation over all phases, cells and classes, at each step.
module Test.Touch.StitchEvidence (spec) where

import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as V
import PraTactile.Image
import PraTactile.Registration.Lattice.Blur (seenAt)
import PraTactile.Registration.Lattice.Evidence
import PraTactile.Registration.Lattice.Layout
import PraTactile.Registration.Lattice.Symbols (symbolsClasses)
import PraTactile.Registration.Lattice.Template
import PraTactile.Registration.Model (Theta (..), cellLog)
import PraTactile.Shape (embossedAt, paperAlphabet, shapes, symbolHeight, symbolWidth)
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess)
import Test.QuickCheck hiding (classes, generate, sample, tables, total)
import Test.Touch.Image (genRasterOf)

spec :: Spec
spec = do
  cellSpec
  modifyMaxSuccess (const 30) frameSpec

cellSpec :: Spec
cellSpec =
  it "a cell is likely as the mean over its classes, and 0.01 for nothing in it" $
    forAll (elements [0.5, 5, 50, 900]) $ \wide ->
      forAll (choose (1, 9) >>= (`vectorOf` choose (negate wide, wide))) $ \told ->
        let found = cellLog (length told) (told !!)
         in counterexample (show (found, cellOf told)) $
              -- What is less likely by e^30 does not count.
              abs (found - cellOf told) < 1e-9 * max 1 (abs found)

-- | The logarithm of the mean of likelihoods, from their logarithms.
cellOf :: [Double] -> Double
cellOf told = top + log (0.01 * exp (negate top) + sum [share * exp (l - top) | l <- told])
  where
    share = 0.99 / fromIntegral (length told)
    top = maximum (0 : told)

-- | Gain, offset and variance.
type Reading = (Double, Double, Double)

-- | What a lattice's cells are likely at a level: for each cell and class; for each cell; for each
-- phase.
data Weighed = Weighed
  { ofClasses :: V.Vector Double,
    ofCells :: V.Vector Double,
    ofPhases :: V.Vector Double
  }

frameSpec :: Spec
frameSpec =
  it "the level is that of four steps at whole taxels and one at all places, and so is the rest" $
    forAllBlind genFrame $ \image -> forAll (elements [0, 0, 30]) $ \angle ->
      let (w, h) = rasterSize image
          tables = tablesOf angle (w, h)
          coarse = coarser tables
          n = fromIntegral (w * h)
          values = rasterValues image
          average = V.sum values / n
          deviation = sqrt (V.sum (V.map (\v -> (v - average) ^ (2 :: Int)) values) / n)
          standard = mapRaster (\v -> (v - average) / deviation) image
          rough = iterate (step everywhere coarse standard) (first standard) !! 4
          wanted = step everywhere tables standard rough
          -- For the hint: by the phases alone that are not less likely at first by e^30.
          few = likely (ofPhases (weighed coarse standard (first standard)))
          hint =
            let one = step everywhere coarse standard (first standard)
             in iterate (step few coarse standard) one !! 3
          told = sight tables image
          Evidence _ (Theta gain offset variance) classes cells phases logs = sightEvidence told
          weights = weighed tables standard wanted
          near :: Double -> String -> [Double] -> [Double] -> Property
          near to what a b =
            counterexample (what ++ show (take 9 [p | p@(x, y) <- zip a b, abs (x - y) >= to])) $
              length a == length b && and (zipWith (\x y -> abs (x - y) < to) a b)
          triple (a, b, c) = [a, b, c]
       in conjoin
            [ near 1e-6 "level" [gain, offset, variance] (triple wanted),
              near 1e-3 "classes" (V.toList classes) (V.toList (ofClasses weights)),
              near 1e-3 "cells" (V.toList cells) (V.toList (ofCells weights)),
              near 1e-3 "phases" (V.toList phases) (V.toList (ofPhases weights)),
              near 1e-3 "log" [logs] [density everywhere wanted weights n],
              near
                1e-3
                "roughly"
                [sightRoughly told]
                [density few hint (weighed coarse standard hint) n]
            ]
  where
    everywhere = const True
    likely phases =
      let these = V.map (> V.maximum phases - 30) phases
       in if 4 * V.length (V.filter id these) > V.length phases then everywhere else (these V.!)
    tablesOf = fromMaybe (error "the alphabet has tables") paperTemplates
    genFrame = do
      (w, h) <- elements [(16, 16), (16, 16), (9, 13)]
      rough <- genRasterOf w h
      noise <- genRasterOf w h
      block <- elements [1, 3, 5]
      place <- (,) <$> half (-12, 24) <*> half (-16, 24)
      shape <- elements (either (error . show) shapes paperAlphabet)
      let blocks x y = if at rough (x `quot` block) (y `quot` block) > 0.6 then 1 else 0
          ramp x y = 0.3 * fromIntegral x - 0.2 * fromIntegral y
      -- Blocks, a symbol as the tables have it, or a slope; with noise or without.
      relief <- elements [blocks, blocks, \x y -> symbol shape place (real x) (real y), ramp]
      share <- elements [0, 0.1, 1]
      pure (generate w h (\x y -> relief x y + share * at noise x y))
    real = fromIntegral :: Int -> Double
    half = fmap ((/ 2) . fromIntegral) . choose :: (Int, Int) -> Gen Double
    symbol shape (px, py) x y =
      sum
        [ seenAt (x - px - fromIntegral a) * seenAt (y - py - fromIntegral b)
          | b <- [0 .. symbolHeight - 1],
            a <- [0 .. symbolWidth - 1],
            embossedAt shape a b
        ]

at :: Raster -> Int -> Int -> Double
at image x y = fromMaybe 0 (index image x y)

-- | Gain and offset usual of symbols, and the noise from second differences.
first :: Raster -> Reading
first image = (gain, -0.15 * gain, noise)
  where
    (w, h) = rasterSize image
    seconds =
      [ at image x y - at image (x + 1) y - at image x (y + 1) + at image (x + 1) (y + 1)
        | x <- [0 .. w - 2],
          y <- [0 .. h - 2]
      ]
    -- Of white noise such a difference has four times the variance.
    noise = max 1e-3 (min 0.95 (squares / (4 * fromIntegral (length seconds))))
    squares = sum (map (^ (2 :: Int)) seconds)
    gain = sqrt (max 0.02 (1 - noise)) / 0.36

-- | How likely everything is at a level: the squared error with a symbol less that without.
weighed :: Templates -> Raster -> Reading -> Weighed
weighed tables image (gain, offset, variance) = Weighed classes cells phases
  where
    count = symbolsClasses (templateSymbols tables)
    products = correlations tables image
    classes =
      V.zipWith3
        (\p s q -> (gain * (p - offset * s) - gain * gain * q / 2) / variance)
        products
        (templateSums tables)
        (templateSquares tables)
    cells =
      V.generate (V.length classes `quot` count) $ \i ->
        cellOf (V.toList (V.slice (i * count) count classes))
    phases =
      V.fromList
        [ sum [cells V.! c | c <- cellsOfPhase (templateLayout tables) k]
          | k <- [0 .. phaseTotal (templateLayout tables) - 1]
        ]

-- | The logarithm of the density of a frame of so many taxels: the mean over all phases, of which
-- some may count.
density :: (Int -> Bool) -> Reading -> Weighed -> Double -> Double
density counts (_, offset, variance) (Weighed _ _ phases) n =
  top
    + log (V.sum (V.map (\l -> exp (l - top)) these) / fromIntegral (V.length phases))
    - n / 2 * log (2 * pi * variance)
    - n * (1 + offset * offset) / (2 * variance)
  where
    these = V.ifilter (const . counts) phases
    top = V.maximum these

-- | By what symbols probably are at a level, the regression of the frame on them: its gain, 0.3 at
-- least, offset, and what is left, 0.002 at least.
step :: (Int -> Bool) -> Templates -> Raster -> Reading -> Reading
step counts tables image level@(gain, offset, _) = (gain', offset', variance')
  where
    Weighed classes cells phases = weighed tables image level
    places = templateLayout tables
    count = symbolsClasses (templateSymbols tables)
    (w, h) = layoutFrame places
    n = fromIntegral (w * h)
    these = V.imap (\k l -> if counts k then l else -1 / 0) phases
    shares = V.map (\l -> exp (l - V.maximum these)) these
    whole = V.sum shares
    -- What is less likely than a millionth does not count.
    counting = [(k, s / whole) | (k, s) <- zip [0 ..] (V.toList shares), s >= 1e-6 * whole]
    sums =
      [ sum [share * inCell numbers c | (k, share) <- counting, c <- cellsOfPhase places k]
        | numbers <- [correlations tables image, templateSums tables, templateSquares tables]
      ]
    inCell numbers c =
      sum
        [ 0.99 / fromIntegral count * exp (classes V.! i - cells V.! c) * (numbers V.! i)
          | i <- [c * count .. c * count + count - 1]
        ]
    (ofImage, ofRelief, ofSquares) = case sums of
      [a, b, c] -> (a, b, c)
      _ -> (0, 0, 0)
    varying = ofSquares - ofRelief * ofRelief / n
    gain' = if varying > 1e-6 then max 0.3 (ofImage / varying) else gain
    offset' = if varying > 1e-6 then negate gain' * ofRelief / n else offset
    left =
      n * (1 + offset' * offset') + gain' * gain' * ofSquares
        - 2 * gain' * (ofImage - offset' * ofRelief)
    variance' = max 2e-3 (left / n)
