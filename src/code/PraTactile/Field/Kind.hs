{-# LANGUAGE AllowAmbiguousTypes #-}
{-# LANGUAGE FlexibleInstances #-}
{-# LANGUAGE TypeApplications #-}
{-# LANGUAGE TypeOperators #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The kind of field indices, and how an index that is written in a type becomes a value.
-- Internal; "PraTactile.Field" exports what users need.
module PraTactile.Field.Kind
  ( Field (..),
    KnownIndex,
    KnownNats (..),
    fieldIndex,
  )
where

import Data.Kind (Type)
import Data.Proxy (Proxy (..))
import GHC.TypeNats (KnownNat, Nat, natVal)
import Numeric.Natural (Natural)

-- | The index that distinguishes fields. It is used as a kind only, never as a type.
data Field
  = -- | The characteristic p, and the modulus, constant term first and monic.
    Over Nat [Nat]
  | -- | A field chosen at run time, named by the type that 'Data.Reflection.reify' makes for its
    -- tables.
    RunTime Type

-- | Indices that are written in a type: p and the modulus as values.
class KnownIndex (k :: Field) where
  -- | p, and the modulus, constant term first.
  fieldIndex :: (Natural, [Natural])

instance (KnownNat p, KnownNats modulus) => KnownIndex ('Over p modulus) where
  fieldIndex = (natVal (Proxy @p), natVals @modulus)

-- | Lists of numbers that are written in a type.
class KnownNats (ns :: [Nat]) where
  -- | The numbers as values.
  natVals :: [Natural]

instance KnownNats '[] where
  natVals = []

instance (KnownNat n, KnownNats ns) => KnownNats (n ': ns) where
  natVals = natVal (Proxy @n) : natVals @ns
