{-# LANGUAGE OverloadedStrings #-}

-- | What the JSON of @locate@ and of @decode@ has in common.
module PraTactile.Format.Outcome
  ( OutcomeName (..),
    outcomeCodec,
    chanceKeys,
  )
where

import PraTactile.Format.Json.Codec
import PraTactile.Locate (Chance (..))

-- | How an answer begins.
data OutcomeName
  = Located
  | SeveralFit
  | NoAnswer
  | -- | What was given is no patch.
    Invalid
  deriving stock (Eq, Show, Enum, Bounded)

-- | An outcome by its name.
outcomeCodec :: Codec OutcomeName
outcomeCodec = named $ \outcome -> case outcome of
  Located -> "located"
  SeveralFit -> "ambiguous"
  NoAnswer -> "refused"
  Invalid -> "invalid"

-- | @chance@ and @chance_is@; both null where no cell was observed.
chanceKeys :: Keys (Maybe Chance) (Maybe Chance)
chanceKeys =
  (\share bound -> Chance <$> share <*> bound)
    <$> key "chance" (nullable real) (fmap chanceShare)
    <*> key "chance_is" (nullable (exactOr "at-most")) (fmap chanceExact)
