{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}

-- | Laws of touch asked with answers of our own: what a trial asks, and its verdict.
module Test.Conformance.Asking
  ( Question' (..),
    asked,
    passes,
    drawn,
    under,

    -- * Places and grey values
    plus,
    minus,
    real,
    within,
    affineOf,
  )
where

import Control.Monad.Trans.Writer.Strict (Writer, runWriter, tell)
import Data.Aeson (FromJSON, Value (..), parseJSON)
import Data.Aeson.Key (Key)
import qualified Data.Aeson.KeyMap as KeyMap
import Data.Aeson.Types (parseMaybe)
import Data.List (nub)
import Data.Maybe (listToMaybe)
import PraTactile.Conformance
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law (Cases (..), Domain (..), Verdict (..))
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (writeValue)
import Test.QuickCheck (vectorOf)
import Test.QuickCheck.Gen (unGen)
import Test.QuickCheck.Random (mkQCGen)

-- | What a trial asks, where all is answered so, and its verdict.
asked :: (forall b. Question b -> b) -> Ask Verdict -> (Verdict, [Question'])
asked answers = runWriter . answerAll (const (pure (Right ()))) reply
  where
    reply :: Question b -> Writer [Question'] (Either Refusal b)
    reply question = Right (answers question) <$ tell [Question' question]

-- | A question of any type.
data Question' = forall b. Question' (Question b)

-- | Some drawn cases of a law, each in the form of the protocol, with its trial.
drawn :: Int -> String -> IO [(Value, Ask Verdict)]
drawn count name = do
  [Cases form domain trial] <- pure [lawCases one () | one <- touchLaws, lawId one == name]
  case domain of
    Some gen _ ->
      pure
        [ (writeValue form one, trial one)
          | one <- unGen (vectorOf count gen) (mkQCGen 1) 50
        ]
    Every _ -> fail (name ++ " draws nothing")

-- | What stands under a key.
under :: FromJSON a => Key -> Value -> a
under key value = case value of
  Object keys | Just found <- KeyMap.lookup key keys >>= parseMaybe parseJSON -> found
  _ -> error ("no " ++ show key ++ " in " ++ show value)

-- | Whether it holds, where all is answered so.
passes :: (forall b. Question b -> b) -> Ask Verdict -> Bool
passes answers trial = fst (asked answers trial) == Holds

plus, minus :: Num a => (a, a) -> (a, a) -> (a, a)
plus (x, y) (x', y') = (x + x', y + y')
minus (x, y) (x', y') = (x - x', y - y')

real :: WholeTaxels -> Taxels
real (x, y) = (fromInteger x, fromInteger y)

-- | The gain, 1 to 3, and the offset of the second rows over the first.
affineOf :: Rows -> Rows -> Maybe (Integer, Integer)
affineOf rows rows' =
  listToMaybe
    [ (gain, offset)
      | gain <- [1 .. 3],
        [offset] <-
          [ nub
              (zipWith (\v v' -> toInteger v' - gain * toInteger v) (concat rows) (concat rows'))
          ]
    ]

-- | Off by this much along one axis.
within :: Double -> [Taxels]
within d = [(d, 0), (-d, 0), (0, d), (0, -d)]
