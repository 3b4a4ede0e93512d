{-# LANGUAGE OverloadedStrings #-}

-- | The common parts of the JSON of @locate@ and of @decode@.
module PraTactile.Format.Outcome
  ( OutcomeName (..),
    outcomeCodec,
    chanceKeys,
    checksCodec,
    foreignKeys,
  )
where

import PraTactile.Format.Json.Codec
import PraTactile.Locate (Chance (..), Checks (..), ForeignDoubts (..), Split (..), doubtOfForeign)

-- | The outcome of a question.
data OutcomeName
  = Located
  | SeveralFit
  | NoAnswer
  | -- | The input was not a patch.
    Invalid
  deriving stock (Eq, Show, Enum, Bounded)

-- | An outcome by its name.
outcomeCodec :: Codec OutcomeName
outcomeCodec = named $ \outcome -> case outcome of
  Located -> "located"
  SeveralFit -> "ambiguous"
  NoAnswer -> "refused"
  Invalid -> "invalid"

-- | @chance@ and @chance_is@; both null if no cell was observed.
chanceKeys :: Keys (Maybe Chance) (Maybe Chance)
chanceKeys =
  (\share bound -> Chance <$> share <*> bound)
    <$> key "chance" (nullable real) (fmap chanceShare)
    <*> key "chance_is" (nullable (exactOr "at-most")) (fmap chanceExact)

-- | The value of @checks@: for columns, rows and sources, the number of checks within single ones
-- and across them.
checksCodec :: Codec (Maybe Checks)
checksCodec =
  nullable . object $
    Checks
      <$> withKeys
        checksOfColumns
        ( Split
            <$> key "within_columns" natural checksWithin
            <*> key "across_columns" natural checksAcross
        )
      <*> withKeys
        checksOfRows
        ( Split
            <$> key "within_rows" natural checksWithin
            <*> key "across_rows" natural checksAcross
        )
      <*> withKeys
        checksOfSources
        ( (\within across -> Split <$> within <*> across)
            <$> key "within_sources" (nullable natural) (fmap checksWithin)
            <*> key "across_sources" (nullable natural) (fmap checksAcross)
        )

-- | @foreign@ and the two probabilities that it is the sum of, when no shapes are compared.
foreignKeys :: Keys ForeignDoubts ForeignDoubts
foreignKeys =
  (\random arrays exact -> ForeignDoubts random arrays exact 0)
    <$ key "foreign" real doubtOfForeign
    <*> key "random" real doubtOfRandom
    <*> key "other_arrays" real doubtOfOtherArrays
    <*> key "other_arrays_is" (exactOr "at-most") otherArraysExact
