-- | The alphabet is a field: the axioms, each as its equation, and what must be refused.
module PraTactile.Conformance.Laws.Field
  ( fieldLaws,
  )
where

import PraTactile.Conformance.Implementation
import PraTactile.Conformance.Law
import PraTactile.Profile (Profile (..))
import Test.QuickCheck

-- | The laws of GF(q).
fieldLaws :: [Law Session]
fieldLaws = axioms ++ otherLaws

-- | The axioms of a field.
axioms :: [Law Session]
axioms =
  [ three
      "a + (b + c) = (a + b) + c"
      (\s a b c -> equal (add s b c >>= add s a) (add s a b >>= \ab -> add s ab c)),
    two "a + b = b + a" (\s a b -> equal (add s a b) (add s b a)),
    one' "a + 0 = a" (\s a -> equal (add s a 0) (pure a)),
    one' "a + (-a) = 0" (\s a -> equal (negation s a >>= add s a) (pure 0)),
    three
      "a (b c) = (a b) c"
      ( \s a b c ->
          equal (multiply s b c >>= multiply s a) (multiply s a b >>= \ab -> multiply s ab c)
      ),
    two "a b = b a" (\s a b -> equal (multiply s a b) (multiply s b a)),
    one' "1 a = a" (\s a -> equal (multiply s 1 a) (pure a)),
    three
      "a (b + c) = a b + a c"
      ( \s a b c ->
          equal (add s b c >>= multiply s a) (multiply s a b >>= \ab -> multiply s a c >>= add s ab)
      ),
    Law
      "a (1/a) = 1 for a other than 0"
      (\s -> forNonZero 1 s (each (\a -> equal (inverse s a >>= multiply s a) (pure 1))))
  ]
  where
    one' name law = Law name (\s -> forElements 1 s (each (law s)))
    two name law =
      Law
        name
        (\s -> forElements 2 s (\codes -> case codes of [a, b] -> law s a b; _ -> property True))
    three name law =
      Law
        name
        ( \s ->
            forElements 3 s (\codes -> case codes of [a, b, c] -> law s a b c; _ -> property True)
        )
    each law = conjoin . map law

-- | The characteristic, and what must be refused.
otherLaws :: [Law Session]
otherLaws =
  [ Law "1/0 is refused: division-by-zero" (\s -> refuses "division-by-zero" (inverse s 0)),
    Law
      "a sum of p ones is 0, p the characteristic"
      (\s -> equal (foldr (const (>>= add s 1)) (pure 0) [1 .. characteristic s]) (pure 0)),
    Law
      "a code of q or more is refused: invalid"
      ( \s ->
          let q = profileOrder (profile s)
           in conjoin
                [ refuses "invalid" (add s q 0),
                  refuses "invalid" (multiply s 0 q),
                  refuses "invalid" (negation s q),
                  refuses "invalid" (inverse s (q + 1))
                ]
      )
  ]
