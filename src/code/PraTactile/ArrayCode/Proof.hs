{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Decides the window property of an array code: whether no content occurs twice in all its
-- arrays. It visits every window of every array, and computes the rank of the mask. Where both
-- methods are possible, they are compared.
module PraTactile.ArrayCode.Proof
  ( proveCode,
    ProvedCode,
    provedCode,
    provedCodeMask,
    CodeVerdict (..),
    CodeProofError (..),
  )
where

import Control.Applicative ((<|>))
import Control.Monad.ST (runST)
import Data.Maybe (listToMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.ArrayCode
import PraTactile.Field
import PraTactile.Polynomial
import PraTactile.Window
import PraTactile.Window.Enumeration (Limits (..), standardLimits)
import PraTactile.Window.Seen
import PraTactile.Window.Visit

-- | What was found about the windows of all arrays, each on its torus.
data CodeVerdict = CodeVerdict
  { -- | whether all windows are distinct
    codeProved :: Bool,
    -- | the number of different contents; 'Nothing' if the windows were not visited
    codeVisited :: Maybe Natural,
    -- | the rank of the mask over GF(q); the windows are distinct exactly if it is n
    codeMaskRank :: Natural,
    -- | two positions with the same content, if the windows were visited and such positions exist
    codeCollision :: Maybe (CodePosition, CodePosition)
  }
  deriving stock (Eq, Show)

-- | Why there is no verdict.
newtype CodeProofError
  = -- | Visiting and rank contradict each other, which a theorem excludes.
    CodeMethodsDisagree CodeVerdict
  deriving stock (Eq, Show)

-- | A code with a mask whose windows are proved to be distinct. Only 'proveCode' makes one.
data ProvedCode (k :: Field) = ProvedCode
  { -- | The code.
    provedCode :: ArrayCode k,
    -- | The windows' shape.
    provedCodeMask :: Mask
  }

type role ProvedCode nominal

-- | Decides whether the windows of all arrays are distinct. It uses the rank, and also visits all
-- windows if there are at most 2^30 possible contents and each array fits in memory. Refuses if the
-- two methods disagree.
proveCode ::
  KnownField k =>
  ArrayCode k ->
  Mask ->
  Either CodeProofError (CodeVerdict, Maybe (ProvedCode k))
proveCode code mask = case visits of
  Just seen | allDistinct seen /= byRank -> Left (CodeMethodsDisagree verdict)
  _ -> Right (verdict, if byRank then Just (ProvedCode code mask) else Nothing)
  where
    r = codeRank code mask
    byRank = r == fromIntegral (primitiveDegree (codePrimitive code))
    visits = jointly code mask
    allDistinct (different, _) = different == period (codePrimitive code)
    verdict =
      CodeVerdict
        { codeProved = byRank,
          codeVisited = fst <$> visits,
          codeMaskRank = r,
          codeCollision = visits >>= snd
        }

-- | The number of different contents, and the first repetition: where the content was first seen,
-- then where it was seen again.
jointly ::
  KnownField k => ArrayCode k -> Mask -> Maybe (Natural, Maybe (CodePosition, CodePosition))
jointly code mask
  | spanned > largestSpan standardLimits = Nothing
  | otherwise = do
    windows <- traverse (\j -> either (const Nothing) Just (codeGrid code j) >>= windowsOf) numbers
    let (different, repeated) = visitAll windows
        positionIn j (r, c) = CodePosition j (visitPosition r c)
        collision = do
          (j, r, c) <- repeated
          later <- lookup j (zip numbers windows)
          first <-
            listToMaybe
              [ positionIn j0 at
                | (j0, w) <- zip numbers windows,
                  at <- everywhere w,
                  keyAt w at == visitKey later r c
              ]
          pure (first, positionIn j (r, c))
    pure (different, collision)
  where
    spanned = fromIntegral (fieldOrder code) ^ maskSize mask
    numbers = naturalsBelow (codeArrays code)
    windowsOf grid = visit MostSignificantFirst Torus grid mask
    keyAt w = uncurry (visitKey w)
    everywhere w = [(r, c) | r <- [0 .. visitRows w - 1], c <- [0 .. visitColumns w - 1]]

-- | Visits all arrays with one bit for each content.
visitAll :: [Visit] -> (Natural, Maybe (Natural, Int, Int))
visitAll windows = runST $ do
  seen <- nothingSeen (maximum (0 : map visitSpan windows))
  let each !_ !different !repeated [] = pure (fromIntegral different, repeated)
      each !j !different !repeated (w : more) = go 0 0 different repeated
        where
          go !r !c !n !again
            | r == visitRows w = each (j + 1) n again more
            | c == visitColumns w = go (r + 1) 0 n again
            | otherwise = do
              new <- insert seen (visitKey w r c)
              if new then go r (c + 1) (n + 1) again else go r (c + 1) n (again <|> Just (j, r, c))
  each 0 (0 :: Int) Nothing windows
