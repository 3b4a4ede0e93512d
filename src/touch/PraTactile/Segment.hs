{-# LANGUAGE DerivingStrategies #-}
module PraTactile.Segment where

import Data.List (foldl')
import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.Maybe (mapMaybe, fromMaybe)
import qualified Data.Vector.Storable as V

import PraTactile.Image
import PraTactile.Image.Correlate
import PraTactile.Stitch.Composite

data SymbolImage = SymbolImage
  { symbolCentre :: !(Double, Double)
  , symbolPixels :: !Raster
  , symbolAxis :: !Double
  , symbolSize :: !(Double, Double)
  } deriving stock (Eq, Show)

data Reject = Reject { rejectBox :: (Double, Double, Double, Double), rejectReason :: String } deriving stock (Eq, Show)

data Segmentation = Segmentation { segmentedSymbols :: [SymbolImage], segmentedRejects :: [Reject], segLevels :: (Double, Double) } deriving stock (Eq, Show)

-- Otsu on a histogram of 256
otsu :: [Double] -> Double
otsu vs = best
 where
  n = 128 :: Int
  lo = minimum vs; hi = maximum vs
  bin v = min (n - 1) (max 0 (floor ((v - lo) / (hi - lo) * fromIntegral n)))
  hist = IntMap.fromListWith (+) [(bin v, 1 :: Double) | v <- vs]
  total = sum (IntMap.elems hist)
  moment = sum [fromIntegral k * c | (k, c) <- IntMap.toList hist]
  (_, _, _, bestBin) = foldl' step (0, 0, -1, 0 :: Int) [0 .. n - 1]
  step (w0, s0, b, k0) k =
    let c = IntMap.findWithDefault 0 k hist
        w = w0 + c; s = s0 + c * fromIntegral k
        m0 = s / w; m1 = (moment - s) / (total - w)
        between = if w <= 0 || total - w <= 0 then -1 else w * (total - w) * (m0 - m1) * (m0 - m1)
    in if between > b then (w, s, between, k) else (w, s, b, k0)
  best = lo + (fromIntegral bestBin + 1) / fromIntegral n * (hi - lo)

segment :: Composite -> Segmentation
segment composite
  | length vs < 64 || hi - lo <= 0 || contrast < 0.1 || contrast < 3 * noise = Segmentation [] [] (0, 0)
  | otherwise = Segmentation [s | Right s <- results] [r | Left r <- results] (bg, fg)
 where
  image = compositeImage composite
  cover = compositeCoverage composite
  w = rasterWidth image; h = rasterHeight image
  touchedAt x y = maybe False (>= 0.4) (index cover x y)
  valueAt x y = fromMaybe 0 (index image x y)
  vs = [ v | (v, m) <- zip (V.toList (rasterValues image)) (V.toList (rasterValues cover)), m >= 0.4 ]
  lo = minimum vs; hi = maximum vs
  t0 = otsu vs
  low = filter (< t0) vs; high = filter (>= t0) vs
  bg = med low; fg = med high
  med [] = 0
  med xs = fromMaybe 0 (either (const Nothing) (quantile 0.5) (fromRows [xs]))
  contrast = fg - bg
  noise = 0 -- later
  level = (bg + fg) / 2
  isFg x y = touchedAt x y && valueAt x y >= level
  mask = IntSet.fromDistinctAscList [ y * w + x | y <- [0 .. h - 1], x <- [0 .. w - 1], isFg x y ]
  dilated = IntSet.fromList [ (y+j) * w + x+i | p <- IntSet.toList mask, let (y, x) = p `quotRem` w, j <- [-1,0,1], i <- [-1,0,1], x+i >= 0, x+i < w, y+j >= 0, y+j < h ]
  comps = components dilated
  components s = case IntSet.minView s of
    Nothing -> []
    Just (p, _) -> let c = flood (IntSet.singleton p) [p] in c : components (s `IntSet.difference` c)
    where
     flood seen [] = seen
     flood seen (p:ps) = let (y, x) = p `quotRem` w
                             ns = [ q | j <- [-1,0,1], i <- [-1,0,1], x+i >= 0, x+i < w, y+j >= 0, y+j < h, let q = (y+j)*w+x+i, IntSet.member q s, not (IntSet.member q seen)]
                         in flood (foldr IntSet.insert seen ns) (ns ++ ps)
  results = mapMaybe oneComp comps
  ref = either (const (referenceOf image)) id (zipRaster (*) image cover >>= \s -> reference s cover)
  oneComp c
    | IntSet.size px < 4 = Nothing
    | otherwise = Just (measure px)
   where px = IntSet.intersection c mask
  measure px
    | not (ok 8 1.6 wdt cutL cutR) || not (ok 12 1.6 hgt cutT cutB) = Left (Reject (l, t, r, b) (show (wdt, hgt, cutL, cutR, cutT, cutB)))
    | otherwise = Right (SymbolImage (cx, cy) pixels 0 (wdt, hgt))
   where
    coords = [ (x, y) | p <- IntSet.toList px, let (y, x) = p `quotRem` w ]
    xmin = minimum (map fst coords); xmax = maximum (map fst coords)
    ymin = minimum (map snd coords); ymax = maximum (map snd coords)
    colProfile x = maximum (0 : [ (valueAt x y + valueAt x (y+1)) / 2 | y <- [ymin .. ymax - 1], touchedAt x y, touchedAt x (y+1) ])
    rowProfile y = maximum (0 : [ (valueAt x y + valueAt (x+1) y) / 2 | x <- [xmin .. xmax - 1], touchedAt x y, touchedAt (x+1) y ])
    edge prof start dir = let at k = prof (start + dir * k)
                              go k | k > 3 = fromIntegral start
                                   | at k >= level && at (k-1) < level = fromIntegral start + fromIntegral dir * (fromIntegral (k-1) + (level - at (k-1)) / (at k - at (k-1)))
                                   | otherwise = go (k + 1)
                          in go (0 :: Int) :: Double
    l = edge colProfile xmin 1; r = edge colProfile xmax (-1)
    t = edge rowProfile ymin 1; b = edge rowProfile ymax (-1)
    cutL = or [ not (touchedAt (x-1) y) | (x, y) <- coords, x <= xmin ]
    cutR = or [ not (touchedAt (x+1) y) | (x, y) <- coords, x >= xmax ]
    cutT = or [ not (touchedAt x (y-1)) | (x, y) <- coords, y <= ymin ]
    cutB = or [ not (touchedAt x (y+1)) | (x, y) <- coords, y >= ymax ]
    wdt = r - l; hgt = b - t
    ok n tol v c1 c2 = abs (v - n) <= (tol :: Double) && (if c1 || c2 then True else True) && (n :: Double) > 0
    place n a z cA cZ | cA && not cZ = z - n / 2
                      | cZ && not cA = a + n / 2
                      | otherwise = (a + z) / 2
    cx = place 8 l r cutL cutR; cy = place 12 t b cutT cutB
    pixels = generate 8 12 (\i j -> let (m, v) = referenceAt ref (cx - 3.5 + fromIntegral i) (cy - 5.5 + fromIntegral j) in if m < 0.05 then 0 else (v - bg) / contrast)
