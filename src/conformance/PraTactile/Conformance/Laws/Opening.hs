{-# OPTIONS_HADDOCK hide #-}

-- | The laws of opening: profiles that describe an array are opened, others are refused.
module PraTactile.Conformance.Laws.Opening
  ( openingLaws,
  )
where

import Data.Aeson (Value (Bool))
import Data.List (nub)
import Numeric.Natural (Natural)
import PraTactile.Array (Folding (..), Position (..), Shape (..), area)
import PraTactile.Conformance.Ask
import PraTactile.Conformance.Definition (ProfileFacts, known, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw (characteristicOf, degreeOf, isVast, periodOf, seenAt)
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Profiles (over)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (listOf)
import PraTactile.Format.Profile (profileCodec, profileValue)
import PraTactile.Profile (Profile (..), canonicalProfile)

-- | The laws about the profiles of the suite: each as it is, and with a change that makes it
-- impossible.
openingLaws :: [Law [Profile]]
openingLaws =
  [ law
      OnProfile
      "possible-ones-are-opened"
      []
      "a profile that describes an array is accepted"
      "the protocol: a possible profile is not refused"
      ( \profiles ->
          Cases
            profileCodec
            (Every (profiles ++ concatMap alike profiles ++ atTheLimits (take 1 profiles)))
            (opened True "the profile names an array")
      ),
    law
      OnProfile
      "polynomial-may-end-in-zeros"
      []
      "zero coefficients at the end of a profile's polynomial are ignored"
      "the protocol, polynomials"
      ( \profiles ->
          Cases
            profileCodec
            (Every [p {profilePolynomial = profilePolynomial p ++ [0, 0]} | p <- take 3 profiles])
            (opened True "the profile names an array")
      ),
    law
      OnProfile
      "profiles-return"
      [SomeOp Term, SomeOp Cell, SomeOp Pack, SomeOp Distance, SomeOp Locate]
      "answers follow the profile in force, whichever profiles were in force before"
      "the protocol: a profile may come at any time"
      ( \profiles ->
          let small = filter (not . isVast) profiles
           in Cases
                (listOf profileCodec)
                ( Every $
                    [[a, b, a] | (a, b) <- take 6 (zip small (drop 1 small))]
                      ++ [[p] | a <- small, p <- take 1 (alike a)]
                      ++ [[ofDegree16], [long]]
                )
                (inTurns [])
      )
  ]
    ++ map impossibleLaw impossibles

-- | Profiles of the same array: in a prime field the modulus may be any monic polynomial of
-- degree 1; three are tried.
alike :: Profile -> [Profile]
alike p =
  [ p {profileModulus = [c, 1]}
    | length (profileModulus p) == 2,
      c <- nub [0, 1, profileOrder p - 1],
      [c, 1] /= profileModulus p
  ]

-- | Profiles with the largest windows, and one with a polynomial of high degree.
atTheLimits :: [Profile] -> [Profile]
atTheLimits profiles =
  ofDegree16 :
    [p {profileWindow = w} | p <- profiles, w <- [Shape 1 4096, Shape 4096 1, Shape 64 64]]

-- | A profile of 65 535 cells; x^16 + x^12 + x^3 + x + 1 is primitive.
ofDegree16 :: Profile
ofDegree16 = over 2 [1, 1] h (Shape 255 257) (Shape 4 4)
  where
    h = [if i `elem` [0, 1, 3, 12, 16 :: Int] then 1 else 0 | i <- [0 .. 16]]

-- | A profile of 205 378 cells for overflows of 32 bits. The index of a term grows by 102 690, the
-- index of the cell (0, 1), with each step along the long side, so before reduction it exceeds 32
-- bits. So does the product of two numbers that are each just below that side's length.
long :: Profile
long = over 59 [1, 1] [49, 42, 47, 1] (Shape 2 102689) (Shape 2 3)

-- | Opens profiles in turn and asks a few questions under each. The violation of a wrong answer
-- includes the profiles that were opened before. A refused profile is opened once more and reported
-- alone.
inTurns :: [Exchange] -> [Profile] -> Ask Verdict
inTurns before profiles = case profiles of
  [] -> pure Holds
  p : others -> do
    got <- opening p
    let now = before ++ [Exchange Nothing (profileValue p) (Result (Bool True))]
    case (got, known p) of
      (Right (), Right about) -> do
        verdicts <- traverse (asDefined about) (fewOf about)
        case [violation | Violated violation <- verdicts] of
          violation : _ ->
            pure (Violated violation {violationAsked = now ++ violationAsked violation})
          [] -> inTurns now others
      _ -> opened True "the profile names an array" p

-- | A question of each of five operations, each of which depends on another part of the profile.
-- The cell lies one row beyond the array.
fewOf :: ProfileFacts -> [SomeQuestion]
fewOf about =
  [ SomeQuestion (Term :? degreeOf p),
    SomeQuestion (Cell :? Position n1 (n2 - 1)),
    SomeQuestion (Pack :? take (fromIntegral (area (profileWindow p))) (cycle [1, 0, 0])),
    SomeQuestion (Distance :? ["##", "##"]),
    SomeQuestion (Locate :? map (map Just) (seenAt about (profileWindow p) lastPlace))
  ]
  where
    p = knownProfile about
    Shape n1 n2 = profileShape p
    Shape h w = profileWindow p
    -- The last position at which a window lies within the edges, if there is one.
    lastPlace = Position (n1 - min n1 h) (n2 - min n2 w)

-- | A condition of profiles (its name and its sentence), and the changed profiles that break it;
-- none if the change does not apply.
data Impossible = Impossible String String (Profile -> [Profile])

impossibleLaw :: Impossible -> Law [Profile]
impossibleLaw (Impossible what sentence change) =
  law
    OnProfile
    what
    []
    (sentence ++ "; any other profile is refused: impossible-profile")
    "MacWilliams and Sloane, Pseudo-random sequences and arrays, Proc. IEEE 64 (1976)"
    ( \profiles ->
        Cases profileCodec (Every (profiles >>= change)) (opened False ("but " ++ sentence))
    )

-- | Opens a profile and judges the reply.
opened :: Bool -> String -> Profile -> Ask Verdict
opened possible reason p = judged <$> opening p
  where
    judged got
      | got == wanted = Holds
      | otherwise =
        Violated
          ( Violation
              [Exchange Nothing (profileValue p) (replied got)]
              (replied wanted)
              road
              reason
          )
    wanted = if possible then Right () else Left (Refusal "impossible-profile")
    road = "the definition of an array"
    replied = either (RefusedFor . refusalReason) (const (Result (Bool True)))

impossibles :: [Impossible]
impossibles = ofTheField ++ ofTheSequence ++ ofTheArray

ofTheField :: [Impossible]
ofTheField =
  [ Impossible "order-is-a-prime-power" "q is a power of a prime, at most 256" $ \p ->
      [p {profileOrder = q} | q <- [0, 1, 6, 10, 12, 257] ++ beyond 8 (profileOrder p)],
    Impossible "modulus-has-the-degree" "the modulus of GF(p^m) has degree m" $ \p ->
      [ p {profileModulus = 1 : profileModulus p},
        p {profileModulus = [1]},
        p
          { profileModulus = []
          }
      ],
    Impossible "modulus-is-monic" "the modulus is monic" $ \p ->
      [p {profileModulus = init' (profileModulus p) ++ [0]} | not (null (profileModulus p))]
        ++ [p {profileModulus = init' (profileModulus p) ++ [2]} | odd (profileOrder p)],
    Impossible "modulus-is-irreducible" "the modulus is irreducible" $ \p ->
      [ p {profileModulus = 0 : replicate (m - 1) 0 ++ [1]}
        | let m = length (profileModulus p) - 1,
          m >= 2
      ]
        ++ [p {profileModulus = [1, 0, 1]} | profileOrder p == 4]
        ++ [p {profileModulus = [1, 1, 1, 1]} | profileOrder p == 8]
        ++ [p {profileModulus = [2, 0, 1]} | profileOrder p == 9],
    Impossible "modulus-is-over-the-prime-field" "the modulus has coefficients below p" $ \p ->
      [ p {profileModulus = c' : rest}
        | c : rest <- [profileModulus p],
          c' <- (c + profileOrder p) : beyond 8 c
      ]
  ]
  where
    init' xs = take (length xs - 1) xs

ofTheSequence :: [Impossible]
ofTheSequence =
  [ Impossible "polynomial-is-monic" "the polynomial is monic" $ \p ->
      [ p {profilePolynomial = lower ++ [c]}
        | let lower = take (length (profilePolynomial p) - 1) (profilePolynomial p),
          c <- 0 : [2 | profileOrder p > 2]
      ],
    Impossible "polynomial-is-primitive" "the polynomial is primitive" $ \p ->
      let n = fromIntegral (degreeOf p)
       in [p {profilePolynomial = 0 : drop 1 (profilePolynomial p)}]
            -- x^n - 1, with x of order n.
            ++ [ p {profilePolynomial = characteristicOf p - 1 : replicate (n - 1) 0 ++ [1]}
                 | periodOf p > degreeOf p
               ]
            ++ imprimitive p,
    Impossible "coefficients-are-elements" "the coefficients are codes below q" $ \p ->
      [ p {profilePolynomial = c' : rest}
        | c : rest <- [profilePolynomial p],
          c' <- (c + profileOrder p) : beyond 8 c
      ],
    Impossible "state-is-not-zero" "the state is not all zeros" $ \p ->
      [p {profileState = map (const 0) (profileState p)}],
    Impossible "state-has-n-terms" "the state has as many terms as the polynomial's degree" $ \p ->
      [p {profileState = 0 : profileState p}, p {profileState = drop 1 (profileState p)}],
    Impossible "state-has-elements" "the terms of the state are codes below q" $ \p ->
      [ p {profileState = s' : rest}
        | s : rest <- [profileState p],
          s' <- (s + profileOrder p) : beyond 8 s
      ]
  ]

-- | A polynomial that is irreducible but not primitive: x^4 + x^3 + x^2 + x + 1 over GF(2) has
-- roots of order 5.
imprimitive :: Profile -> [Profile]
imprimitive p =
  [p {profilePolynomial = [1, 1, 1, 1, 1]} | profileOrder p == 2, degreeOf p == 4]

ofTheArray :: [Impossible]
ofTheArray =
  [ Impossible "cells-are-a-period" "an array has as many cells as the sequence has terms" $ \p ->
      let Shape n1 n2 = profileShape p
       in [ p {profileShape = shape}
            | shape <-
                [Shape (n1 + 1) n2, Shape n1 (n2 + 1), Shape n2 (n1 + n2), Shape 0 n2, Shape 1 1]
                  ++ [Shape (n1 - 1) n2 | n1 > 1]
                  ++ [Shape n1 (n2 - 1) | n2 > 1]
                  ++ wider (profileShape p),
              area shape /= area (profileShape p)
          ],
    Impossible "sides-are-coprime" "the sides of a diagonal fold are coprime" $ \p ->
      [noncoprime | p == canonicalProfile]
        ++ [ p {profileShape = Shape a b}
             | profileFolding p == Diagonal,
               a <- [2 .. 12],
               area (profileShape p) `mod` a == 0,
               let b = area (profileShape p) `div` a,
               gcd a b > 1
           ],
    Impossible "window-has-cells" "a window has from 1 to 4096 cells" $ \p ->
      [ p {profileWindow = w}
        | w <- [Shape 0 2, Shape 2 0, Shape 1 4097, Shape 65 64] ++ wider (profileWindow p)
      ]
  ]
  where
    wider (Shape a b) = map (`Shape` b) (beyond 16 a) ++ map (Shape a) (beyond 16 b)

-- | Larger numbers that become the given one when truncated to 8, 16, 32 or 64 bits (at least the
-- given number of bits).
beyond :: Int -> Natural -> [Natural]
beyond least n = [n + 2 ^ bits | bits <- [8, 16, 32, 64], bits >= least]

-- | The larger example of Petriu and others (2004): 3 divides both sides.
noncoprime :: Profile
noncoprime = over 4 [1, 1, 1] [2, 1, 1, 0, 0, 0, 1] (Shape 15 273) (Shape 2 3)
