{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_GHC -O2 #-}

-- | What the decoders make of a trial. They are asked in two ways: by themselves, which is the
-- definition; and for all that is needed of them at once, which is fast enough for millions of
-- trials. The tests compare the two.
module PraTactile.Rates.Verdict
  ( Verdict (..),
    Answer (..),
    judge,
    judgeByDecoders,
  )
where

import Data.Bits (popCount, testBit, xor, (.&.), (.|.))
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Data.Word (Word64)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
  ( Outcome (..),
    Posterior (..),
    Radius (..),
    belief,
    guaranteedRadius,
    likeliest,
    patch,
  )
import PraTactile.Locate.Decision (Decision (..))
import PraTactile.Locate.Decoder.Nearest (nearest)
import PraTactile.Locate.Decoder.Posterior (posterior)
import PraTactile.Rates.Ground
import PraTactile.Rates.Trial

-- | What became of a trial.
data Verdict = Verdict
  { -- | By hard decoding: of the likeliest symbols, to the radius stated.
    verdictAnswer :: !Answer,
    -- | By soft decoding: whether the likeliest position is the true one.
    verdictLikeliest :: !Bool,
    -- | The probability that it is another one.
    verdictDoubt :: !Double
  }
  deriving stock (Eq, Show)

-- | An answer beside the truth.
data Answer = Correct | Mistaken | NoAnswer
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The verdict, by 'nearest' and 'posterior'.
judgeByDecoders :: forall k. KnownField k => Radius -> Ground k -> Trial -> Maybe Verdict
judgeByDecoders radius place trial = do
  readings <-
    traverse
      (traverse reading)
      (chunked (fromIntegral (columns (groundShape place))) [0 .. groundCells place - 1])
  soft <- either (const Nothing) Just (patch readings)
  let found = posterior shelf soft
      answer = case decisionOutcome (nearest shelf radius (likeliest <$> soft)) of
        Unique at _ -> if at == true then Correct else Mistaken
        _ -> NoAnswer
  pure (Verdict answer (posteriorBest found == Just true) (posteriorDoubt found))
  where
    shelf = groundBook place
    true = positionOf shelf (trialPosition trial)
    q = fieldOrder (Proxy :: Proxy k)
    reading j
      | not (testBit (trialSeen trial Primitive.! (j `div` 64)) (j `mod` 64)) = Just Nothing
      | otherwise = either (const Nothing) (Just . Just) (belief (map (/ sum weights) weights))
      where
        evidence = Primitive.toList (Primitive.slice (j * q) q (trialEvidence trial))
        weights = map (\x -> exp (x - maximum evidence)) evidence
    chunked size xs = case splitAt size xs of
      ([], _) -> []
      (first, others) -> first : chunked size others

-- | The verdict, as 'judgeByDecoders' has it.
judge :: Radius -> Ground k -> Trial -> Verdict
judge radius place trial = Verdict answer (best == true) (others / (1 + others))
  where
    true = trialPosition trial
    seen = trialSeen trial
    n = groundCells place
    limbs = groundLimbs place
    planes = groundPlanes place
    positions = groundPositions place
    observed = Primitive.foldl' (\k limb -> k + popCount limb) 0 seen

    -- Hard decoding: the least distance to a position, how many have it, one of them; and the least
    -- weight of an observed content.
    answer = hard 0 maxBound 0 0 maxBound
    hard :: Int -> Int -> Int -> Int -> Int -> Answer
    hard !i !least !count !at !weight
      | i < positions =
        let e = differing (i * limbs) 0 0
            w = min weight (supported (i * limbs) 0 0)
         in if e < least
              then hard (i + 1) e 1 i w
              else hard (i + 1) least (if e == least then count + 1 else count) at w
      | observed == 0 || count > 1 || least > farthest weight = NoAnswer
      | at == true = Correct
      | otherwise = Mistaken
    farthest weight = case radius of
      Guaranteed -> fromIntegral (guaranteedRadius (fromIntegral weight))
      UpTo e -> fromIntegral (min e (fromIntegral n))
    differing :: Int -> Int -> Int -> Int
    differing !from !l !total
      | l == limbs = total
      | otherwise =
        differing
          from
          (l + 1)
          (total + popCount (unlike (planes * (from + l)) (planes * l) 0 0 .&. seenAt l))
    unlike :: Int -> Int -> Int -> Word64 -> Word64
    unlike !from !own !b !bits
      | b == planes = bits
      | otherwise = unlike from own (b + 1) (bits .|. (digitAt (from + b) `xor` symbolAt (own + b)))
    supported :: Int -> Int -> Int -> Int
    supported !from !l !total
      | l == limbs = total
      | otherwise = supported from (l + 1) (total + popCount (supportAt (from + l) .&. seenAt l))
    -- All indices are below the positions, times the limbs, times the planes.
    seenAt = Primitive.unsafeIndex seen
    digitAt = Primitive.unsafeIndex (groundDigits place)
    symbolAt = Primitive.unsafeIndex (trialSymbols trial)
    supportAt = Primitive.unsafeIndex (groundSupports place)

    -- Soft decoding: the first of the likeliest positions, and how likely the others are beside it.
    totals = Primitive.generate positions (\i -> likelihood (i * n) ((i + 1) * n) 0)
    likelihood :: Int -> Int -> Double -> Double
    likelihood !i !end !total
      | i == end = total
      | otherwise = likelihood (i + 1) end (total + evidenceAt (contentAt i))
    evidenceAt = Primitive.unsafeIndex (trialEvidence trial)
    contentAt i = fromIntegral (Primitive.unsafeIndex (groundContents place) i)
    best = Primitive.maxIndex totals
    highest = Primitive.unsafeIndex totals best
    others = beside 0 0
    beside :: Int -> Double -> Double
    beside !i !total
      | i == positions = total
      | i == best || x < negligible = beside (i + 1) total
      | otherwise = beside (i + 1) (total + exp x)
      where
        x = Primitive.unsafeIndex totals i - highest
    -- All together not 1e-28, where no doubt below 1e-20 is told from another.
    negligible = -80
