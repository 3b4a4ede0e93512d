-- | Laws, and the few words they are said in.
module PraTactile.Conformance.Law
  ( -- * Laws
    Law (..),

    -- * Saying them
    equal,
    refuses,
    holds,

    -- * Drawing values
    forElements,
    forNonZero,
    forTerms,
    forPositions,
    forWindows,

    -- * Of the field
    characteristic,
  )
where

import Control.Monad.Trans.Except (runExceptT)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..), Surface (..), area)
import PraTactile.Conformance.Implementation
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | A name, which is the equation or the sentence, and what must hold of an implementation or a
-- session with it.
data Law subject = Law
  { lawName :: String,
    lawProperty :: subject -> Property
  }

-- | Both sides answer, and answer the same.
equal :: (Eq a, Show a) => Wire a -> Wire a -> Property
equal left right = ioProperty $ do
  l <- runExceptT left
  r <- runExceptT right
  pure (either (const False) (const True) l === True .&&. l === r)

-- | The implementation refuses for this reason.
refuses :: Show a => String -> Wire a -> Property
refuses expected action = ioProperty $ do
  outcome <- runExceptT action
  pure $ case outcome of
    Left found -> found === Refusal expected
    Right answer ->
      counterexample ("answered " ++ show answer ++ " instead of refusing: " ++ expected) False

-- | The implementation answers, and the answer satisfies this.
holds :: Show a => (a -> Bool) -> Wire a -> Property
holds condition action = ioProperty $ do
  outcome <- runExceptT action
  pure $ case outcome of
    Left found -> counterexample ("refused: " ++ show found) False
    Right answer -> counterexample (show answer) (condition answer)

-- | For lists of this many elements.
forElements :: Int -> Session -> ([Code] -> Property) -> Property
forElements = forCodes 0

-- | For lists of this many elements other than 0.
forNonZero :: Int -> Session -> ([Code] -> Property) -> Property
forNonZero = forCodes 1

forCodes :: Integer -> Int -> Session -> ([Code] -> Property) -> Property
forCodes least count session = forAllShrink (vectorOf count code) shrunk
  where
    q = toInteger (profileOrder (profile session))
    code = fromInteger <$> chooseInteger (least, q - 1)
    shrunk codes =
      [ before ++ smaller : after
        | (i, c) <- zip [0 ..] codes,
          let before = take i codes,
          let after = drop (i + 1) codes,
          smaller <-
            map fromInteger (filter (>= least) (shrinkIntegral (toInteger c) `orBelow` toInteger c))
      ]
    orBelow candidates c = [n | n <- candidates, n >= 0, n < c]

-- | For indices of terms, from 0 to beyond a few periods.
forTerms :: Session -> (Natural -> Property) -> Property
forTerms session =
  forAllShrink (fromInteger <$> chooseInteger (0, 4 * toInteger cells)) shrinkNatural
  where
    cells = area (profileShape (profile session))

-- | For positions of the array.
forPositions :: Session -> (Position -> Property) -> Property
forPositions session = forPositionsIn (profileShape (profile session))

-- | For positions at which a whole window lies on the profile's surface.
forWindows :: Session -> (Position -> Property) -> Property
forWindows session = forPositionsIn $ case profileSurface p of
  Sheet -> Shape (less rows) (less columns)
  _ -> profileShape p
  where
    p = profile session
    less side =
      if side (profileWindow p) > side (profileShape p)
        then 0
        else side (profileShape p) - side (profileWindow p) + 1

-- | For all positions where there are not more than 4096, otherwise for drawn ones.
forPositionsIn :: Shape -> (Position -> Property) -> Property
forPositionsIn (Shape high wide) property'
  | high == 0 || wide == 0 = property True
  | high * wide <= 4096 =
    once
      ( conjoin
          [ counterexample (show place) (property' place)
            | r <- [0 .. high - 1],
              c <- [0 .. wide - 1],
              let place = Position r c
          ]
      )
  | otherwise =
    forAllShrink
      (Position <$> below high <*> below wide)
      ( \(Position r c) ->
          [Position r' c | r' <- shrinkNatural r] ++ [Position r c' | c' <- shrinkNatural c]
      )
      property'
  where
    below n = fromInteger <$> chooseInteger (0, toInteger n - 1)

shrinkNatural :: Natural -> [Natural]
shrinkNatural n = [fromInteger i | i <- shrinkIntegral (toInteger n), i >= 0]

-- | p, where the field has p^m elements: the least divisor of their number above 1.
characteristic :: Session -> Natural
characteristic session = foldr const q [d | d <- [2 .. q], q `mod` d == 0]
  where
    q = profileOrder (profile session)
