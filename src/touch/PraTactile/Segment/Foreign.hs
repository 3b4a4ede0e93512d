-- | What in a composite is none of the symbols' making: bars, rims, plateaus, holes, and what lies
-- beyond the object's edge. It would spoil the levels of background and embossing, and the estimate
-- of the angle, for the whole composite.
--
-- How high the symbols stand is taken from the symbols alone: what is of a symbol's size where it
-- is cut off at half its own height above its own surroundings. By these levels, what is longer
-- than any symbol is foreign, and so is what is sunk; it is taken out of the composite, as if it
-- had not been touched. The symbols beside it stay.
module PraTactile.Segment.Foreign
  ( Cleaned (..),
    withoutForeign,

    -- * Shapes of regions
    tooLong,
    symbolSized,
    unlikeSymbols,
    straight,
  )
where

import Data.List (sort, sortOn)
import Data.Maybe (fromMaybe)
import qualified Data.Set as Set
import qualified Data.Vector.Storable as V
import PraTactile.Geometry (symbolHeight, symbolWidth)
import PraTactile.Image
import PraTactile.Segment.Level
import PraTactile.Segment.Region
import PraTactile.Segment.Reject
import PraTactile.Stitch.Composite (Composite (..))

-- | A composite without what is foreign.
data Cleaned = Cleaned
  { -- | what symbols are cut out of
    cleanedComposite :: !Composite,
    -- | what parts of symbols are read from, if that is another: with what is foreign but of the
    -- symbols' height left in, for what of a symbol lies beside it still shows which it is
    cleanedForParts :: !(Maybe Composite),
    cleanedRejects :: ![Reject]
  }
  deriving stock (Eq, Show)

-- | The composite with what is foreign taken for untouched, given the least weight with which a
-- pixel counts as touched, and what that is. Where all that is embossed is like symbols, or nothing
-- is, and nothing is sunk, the composite stays as it is.
withoutForeign :: Double -> Composite -> Cleaned
withoutForeign least composite = case levels noise seen of
  Just found
    | any (unlikeSymbols field) (regions field 0 (marked field (>= share 0.5 found)))
        || not (null (hollows (marked field (<= share (-0.35) found)))),
      Just (own, symbols) <- symbolLevels field noise ->
      removed composite field (foreignIn field own symbols)
  _ -> Cleaned composite Nothing []
  where
    field = fieldOf least composite
    seen = V.ifilter (\p _ -> fieldTouched field V.! p) (fieldValues field)
    noise = smoothing * pixelNoise field (compositeImage composite)
    hollows = filter ((>= leastHollow) . length) . regions field 0

-- | The touched pixels whose values are so.
marked :: Field -> (Double -> Bool) -> V.Vector Bool
marked field test = V.zipWith (\t v -> t && test v) (fieldTouched field) (fieldValues field)

-- | A share of the way from the background's level to the embossing's.
share :: Double -> Levels -> Double
share part found = levelBackground found + part * contrast found

-- | A composite without some regions.
removed :: Composite -> Field -> [Strange] -> Cleaned
removed composite field strange
  | null strange = Cleaned composite Nothing []
  | otherwise =
    Cleaned
      (without strange)
      (Just (without (filter strangeHeight strange)))
      [Reject (regionBox field region) cause | Strange region cause _ <- strange]
  where
    without some =
      composite
        { compositeImage = blank (compositeImage composite),
          compositeCoverage = blank (compositeCoverage composite)
        }
      where
        gone = around field 0 (concatMap strangePixels some)
        blank image =
          generate (fieldWidth field) (fieldHeight field) $ \x y ->
            if gone V.! (y * fieldWidth field + x) then 0 else fromMaybe 0 (index image x y)

-- | A foreign region.
data Strange = Strange
  { strangePixels :: !Region,
    _strangeCause :: !Cause,
    -- | whether no symbol is so high, or so low
    strangeHeight :: !Bool
  }

-- | Is a region longer than any symbol, or whole, not small, and yet not of a symbol's size?
unlikeSymbols :: Field -> Region -> Bool
unlikeSymbols field region =
  tooLong field region
    || (length region >= leastWhole && not atEdge && not (symbolSized field region))
  where
    atEdge =
      or
        [ maybe True (not . (fieldTouched field V.!)) (beside field p by)
          | p <- region,
            by <- [(-1, 0), (1, 0), (0, -1), (0, 1)]
        ]

-- | What has fewer pixels may be a piece of a symbol.
leastWhole :: Int
leastWhole = 36

-- | Is a region longer than a symbol at any angle?
tooLong :: Field -> Region -> Bool
tooLong field region =
  or [extentAlong field region angle > longest | angle <- [0, 22.5 .. 157.5]]

-- | More than a symbol's diagonal, in pixels.
longest :: Double
longest = 18

-- | Something that may be a symbol.
data Candidate = Candidate
  { candidatePixels :: !Region,
    candidateLevels :: !Levels,
    -- | how far from half its height it was cut off, as a share of the height
    candidateMisfit :: !Double
  }

-- | The levels of what may be symbols, and the pixels of these; 'Nothing' where nothing may be one.
symbolLevels :: Field -> Double -> Maybe (Levels, [Region])
symbolLevels field noise
  | null found = Nothing
  | otherwise = Just (Levels low (low + usual), map candidatePixels alike)
  where
    found = distinct (candidates field noise)
    usual = middle (map (contrast . candidateLevels) found)
    alike =
      [ c
        | c <- found,
          let ratio = contrast (candidateLevels c) / usual,
          ratio > 0.5 && ratio < 1.6
      ]
    low = middle (map (levelBackground . candidateLevels) alike)

-- | Of candidates that share pixels, the one that fits best.
distinct :: [Candidate] -> [Candidate]
distinct = go Set.empty . sortOn candidateMisfit
  where
    go _ [] = []
    go taken (c : others)
      | any (`Set.member` taken) (candidatePixels c) = go taken others
      | otherwise = c : go (foldr Set.insert taken (candidatePixels c)) others

-- | The regions of a symbol's size above each of a ladder of thresholds that lie nearly at half
-- their own height.
candidates :: Field -> Double -> [Candidate]
candidates field noise
  | V.null seen = []
  | otherwise =
    [ c
      | k <- [1 .. rungs - 1],
        let t = bottom + (top - bottom) * fromIntegral k / fromIntegral rungs,
        let over = marked field (>= t),
        gap <- [0, 2],
        region <- regions field gap over,
        symbolSized field region,
        Just c <- [candidate field t region],
        contrast (candidateLevels c) >= max (2 / 255) (4 * noise),
        candidateMisfit c < 0.2
    ]
  where
    seen = V.ifilter (\p _ -> fieldTouched field V.! p) (fieldValues field)
    (bottom, top) = (V.minimum seen, V.maximum seen)

-- | How many steps the ladder of thresholds has.
rungs :: Int
rungs = 24

-- | Is the region as long and as wide as a symbol, at some angle?
symbolSized :: Field -> Region -> Bool
symbolSized field region =
  length region >= 24 && length region <= 110
    && or
      [ fits long short || fits short long
        | angle <- [0, 5 .. 85],
          let long = extentAlong field region angle,
          let short = extentAlong field region (angle + 90)
      ]
  where
    fits long short =
      abs (long - fromIntegral symbolHeight) <= 1.8
        && abs (short - fromIntegral symbolWidth) <= 1.8
        && long - short >= 2

-- | A region above a threshold, with the levels of itself and of what lies three pixels from it.
candidate :: Field -> Double -> Region -> Maybe Candidate
candidate field t region
  | length ring < 12 || high <= low = Nothing
  | otherwise =
    Just (Candidate region (Levels low high) (abs (t - (low + high) / 2) / (high - low)))
  where
    near = around field 2 region
    ring =
      [ fieldValues field V.! p
        | p <- grown field 3 region,
          not (near V.! p),
          fieldTouched field V.! p
      ]
    low = middle ring
    high = ranked 0.7 [fieldValues field V.! p | p <- region]

-- | The value of a rank among some, from 0 to 1; 0 for none.
ranked :: Double -> [Double] -> Double
ranked rank values = case drop (floor (rank * fromIntegral (length values))) (sort values) of
  v : _ -> v
  [] -> 0

middle :: [Double] -> Double
middle = ranked 0.5

-- | The foreign regions, given the symbols' levels and pixels: each with a rim, but for what is a
-- symbol's and its rim. What stands clearly higher than symbols goes first, for a symbol close to
-- it is not parted from it at a lower level.
foreignIn :: Field -> Levels -> [Region] -> [Strange]
foreignIn field own symbols =
  [Strange region TooLarge True | region <- high]
    ++ [Strange (widened 1 region) TooLarge False | region <- raised]
    ++ [Strange (widened 2 region) Hollow True | region <- sunken, length region >= leastHollow]
  where
    kept = around field 1 (concat symbols)
    free = V.zipWith (\keep m -> m && not keep) kept
    high = map (widened 2) (filter (tooLong field) (found (free (marked field (>= share 1.5 own)))))
    rest = V.zipWith (\gone m -> m && not gone) (around field 0 (concat high))
    raised = concatMap (straight field) (filter (tooLong field) (found level))
    level = rest (free (marked field (>= share 0.35 own)))
    sunken = found (free (marked field (<= share (-0.35) own)))
    found = regions field 0
    widened by region = [p | p <- grown field by region, not (kept V.! p)]

-- | The parts of a region that lie on straight lines within it, longer than any symbol has: of a
-- symbol that touches a bar only what lies on lines through both.
straight :: Field -> Region -> [Region]
straight field region = regions field 0 (around field 0 onLines)
  where
    within = around field 0 region
    onLines =
      concat
        [ map fst line
          | p <- region,
            angle <- [0, 11.25 .. 168.75],
            let line = [(p', within V.! p') | Just p' <- map (beside field p) (steps angle)],
            length (filter snd line) >= longestLine - 1
        ]
    steps :: Double -> [(Int, Int)]
    steps angle =
      [ (round (t * cos (angle * pi / 180)), round (t * sin (angle * pi / 180)))
        | t <- map fromIntegral [0 .. longestLine - 1]
      ]

-- | No line of so many pixels, but for one of them, lies within a symbol.
longestLine :: Int
longestLine = 17

-- | Fewer sunken pixels are noise.
leastHollow :: Int
leastHollow = 12
