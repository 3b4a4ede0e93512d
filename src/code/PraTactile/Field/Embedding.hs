{-# OPTIONS_HADDOCK hide #-}

-- | Embeddings of GF(p^d) into GF(p^m), and isomorphisms between GF(p^m) with different moduli.
-- Implementations with different moduli translate their codes by an isomorphism.
module PraTactile.Field.Embedding
  ( -- * Making
    Embedding,
    isomorphism,
    embedding,
    embeddings,

    -- * Using
    embed,
    retract,
    inverseEmbedding,
  )
where

import Data.List (find, unfoldr)
import Data.Proxy (Proxy (..))
import qualified Data.Vector.Primitive as Primitive
import Numeric.Natural (Natural)
import PraTactile.Field
import PraTactile.Field.Structure
import PraTactile.Polynomial

-- | A map from the field j to the field k that preserves sums and products. It is stored as the
-- image of each element of j, by its code.
newtype Embedding (j :: Field) (k :: Field) = Embedding (Primitive.Vector (GF k))

type role Embedding nominal nominal

-- | All embeddings of j into k. The class of x in j = Z_p[x]/f must go to a root of f in k, which
-- determines the embedding. They are listed by increasing code of that root. Their number is the
-- degree of j over GF(p), or 0 if j is not contained in k.
embeddings :: forall j k. (KnownField j, KnownField k) => [Embedding j k]
embeddings
  | fieldCharacteristic j /= fieldCharacteristic (Proxy :: Proxy k) = []
  | otherwise = map sendingTo (filter isRoot elements)
  where
    j = Proxy :: Proxy j
    p = fieldCharacteristic j
    isRoot a = valueAt (fromIntegers (map toInteger (fieldModulus j))) a == zero
    sendingTo root = Embedding (Primitive.generate (fieldOrder j) (image root))
    image root code = valueAt (fromIntegers (digits code)) root
    digits = unfoldr (\c -> if c == 0 then Nothing else Just (toInteger (c `mod` p), c `div` p))

-- | Integers as the coefficients of a polynomial, constant term first.
fromIntegers :: KnownField k => [Integer] -> Polynomial k
fromIntegers = polynomial . map fromInteger

-- | The first of the 'embeddings'. Refuses ('NotContained') a field j that is not contained in k.
embedding :: forall j k. (KnownField j, KnownField k) => Either StructureError (Embedding j k)
embedding = case embeddings of
  first : _ -> Right first
  [] -> Left (NotContained (primeAndDegree (Proxy :: Proxy j)) (primeAndDegree (Proxy :: Proxy k)))

-- | The first of the isomorphisms between two forms of one field. Refuses ('NotIsomorphic') fields
-- of different order.
isomorphism :: forall j k. (KnownField j, KnownField k) => Either StructureError (Embedding j k)
isomorphism
  | primeAndDegree j == primeAndDegree k = embedding
  | otherwise = Left (NotIsomorphic (primeAndDegree j) (primeAndDegree k))
  where
    j = Proxy :: Proxy j
    k = Proxy :: Proxy k

-- | p and m of GF(p^m).
primeAndDegree :: KnownField k => Proxy k -> (Natural, Natural)
primeAndDegree k = (fromIntegral (fieldCharacteristic k), fromIntegral (fieldDegree k))

-- | The image of an element.
--
-- GF(2) in GF(4):
--
-- >>> import PraTactile.Field.Named (GF2, GF4)
-- >>> fmap (\e -> map (embed e) elements) (embedding :: Either StructureError (Embedding GF2 GF4))
-- Right [0,1]
embed :: Embedding j k -> GF j -> GF k
-- The table has as many entries as j has codes.
embed (Embedding table) a = table Primitive.! toCode a

-- | The element that has this image; 'Nothing' outside the image of the embedding.
retract :: KnownField j => Embedding j k -> GF k -> Maybe (GF j)
retract e b = find ((== b) . embed e) elements

-- | The inverse of an isomorphism. Refuses ('NotIsomorphic') an embedding into a larger field.
inverseEmbedding ::
  forall j k. (KnownField j, KnownField k) => Embedding j k -> Either StructureError (Embedding k j)
inverseEmbedding e = case traverse (retract e) elements of
  Just preimages -> Right (Embedding (Primitive.fromList preimages))
  Nothing ->
    Left (NotIsomorphic (primeAndDegree (Proxy :: Proxy j)) (primeAndDegree (Proxy :: Proxy k)))
