-- | Profiles that name no array, of which each law of profiles has its own.
module Test.Conformance.Cases.Impossible (impossible) where

import Data.Maybe (fromMaybe)
import PraTactile.Array (Folding (..), Shape (..), area)
import PraTactile.Conformance
import PraTactile.Profile

-- | Profiles that name no array, by the laws' ids: of each default profile, one key changed.
impossible :: [(String, [Profile])]
impossible =
  [ ("profile/" ++ name, map snd defaultProfiles >>= change)
    | (name, change) <- ofField' ++ ofSequence' ++ ofArray'
  ]
  where
    ofField' =
      [ ("order-is-a-prime-power", \p -> [p {profileOrder = q} | q <- [0, 1, 6, 10, 12]]),
        ( "modulus-has-the-degree",
          \p -> [p {profileModulus = h} | h <- [1 : profileModulus p, [1], []]]
        ),
        ( "modulus-is-monic",
          \p ->
            [ p {profileModulus = lower (profileModulus p) ++ [leading]}
              | leading <- 0 : [2 | odd (profileOrder p)]
            ]
        ),
        ( "modulus-is-irreducible",
          \p ->
            [ p {profileModulus = h}
              | h <-
                  [0 : drop 1 (lower (map (const 0) (profileModulus p))) ++ [1] | isExtension p]
                    -- (x + 1)^2, (x + 1)^3, (x + 1)(x - 1).
                    ++ [ h
                         | (q, h) <- [(4, [1, 0, 1]), (8, [1, 1, 1, 1]), (9, [2, 0, 1])],
                           q == profileOrder p
                       ]
            ]
        ),
        ( "modulus-is-over-the-prime-field",
          \p -> [p {profileModulus = (c + profileOrder p) : h} | c : h <- [profileModulus p]]
        )
      ]
    ofSequence' =
      [ ( "polynomial-is-monic",
          \p ->
            [ p {profilePolynomial = lower (profilePolynomial p) ++ [c]}
              | c <- 0 : [2 | profileOrder p > 2]
            ]
        ),
        ( "polynomial-is-primitive",
          \p ->
            [ p {profilePolynomial = h}
              | let n = length (profileState p),
                h <-
                  -- Divisible by x; x^n - 1; x^4 + x^3 + x^2 + x + 1, with roots of order 5.
                  [ 0 : drop 1 (profilePolynomial p),
                    minusOne p : replicate (n - 1) 0 ++ [1]
                  ]
                    ++ [[1, 1, 1, 1, 1] | profileOrder p == 2, n == 4]
            ]
        ),
        ( "coefficients-are-elements",
          \p -> [p {profilePolynomial = (c + profileOrder p) : h} | c : h <- [profilePolynomial p]]
        ),
        ("state-is-not-zero", \p -> [p {profileState = map (const 0) (profileState p)}]),
        ( "state-has-n-terms",
          \p -> [p {profileState = s} | s <- [0 : profileState p, drop 1 (profileState p)]]
        ),
        ( "state-has-elements",
          \p -> [p {profileState = (c + profileOrder p) : s} | c : s <- [profileState p]]
        )
      ]
    ofArray' =
      [ ( "cells-are-a-period",
          \p ->
            [ p {profileShape = shape}
              | let Shape a b = profileShape p,
                shape <- [Shape (a + 1) b, Shape a (b + 1), Shape b (a + b), Shape 0 b],
                area shape /= area (profileShape p)
            ]
        ),
        ( "sides-are-coprime",
          \p ->
            [larger | p == canonicalProfile]
              ++ [ p {profileShape = Shape a (area (profileShape p) `div` a)}
                   | profileFolding p == Diagonal,
                     a <- [2 .. 12],
                     area (profileShape p) `mod` a == 0,
                     gcd a (area (profileShape p) `div` a) /= 1
                 ]
        ),
        ("window-has-cells", \p -> [p {profileWindow = w} | w <- [Shape 0 2, Shape 2 0]])
      ]
    lower xs = take (length xs - 1) xs
    isExtension p = length (profileModulus p) > 2
    minusOne p = fromMaybe 1 (lookup (profileOrder p) [(3, 2), (5, 4), (9, 2)])
    -- The larger example of the paper.
    larger =
      canonicalProfile
        { profilePolynomial = [2, 1, 1, 0, 0, 0, 1],
          profileState = [0, 0, 0, 0, 0, 1],
          profileShape = Shape 15 273,
          profileWindow = Shape 2 3
        }
