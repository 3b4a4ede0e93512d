-- | Implementations that are wrong, each under a profile that shows it.
module Test.Conformance.Mutants
  ( Mutant (..),
    fieldMutants,
    sequenceMutants,
    arrayMutants,
    locateMutants,
    damageMutants,
    over,
    opened,
  )
where

import Control.Applicative ((<|>))
import Control.Monad.Trans.Except (catchE, runExceptT, throwE)
import Data.Maybe (fromMaybe)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (Shape), Surface (..))
import PraTactile.Conformance
import PraTactile.Profile

opened :: Profile -> IO Session
opened chosen = runExceptT (open library chosen) >>= either (fail . show) pure

-- | An implementation with a mistake, under a profile that shows it.
data Mutant = Mutant
  { mutantName :: String,
    mutantProfile :: Profile,
    mistaken :: Session -> IO Session
  }

fieldMutants :: [Mutant]
fieldMutants =
  [ Mutant
      "adds codes as numbers modulo q"
      canonicalProfile
      (\s -> pure s {add = \a b -> add s a 0 >> add s b 0 >> pure ((a + b) `mod` 4)}),
    Mutant
      "multiplies codes as numbers modulo q"
      canonicalProfile
      (\s -> pure s {multiply = \a b -> pure (a * b `mod` 4)}),
    Mutant "keeps the first summand" canonicalProfile (\s -> pure s {add = \a _ -> pure a}),
    Mutant "keeps the second summand" canonicalProfile (\s -> pure s {add = \_ b -> pure b}),
    Mutant
      "has one sum wrong"
      canonicalProfile
      (\s -> pure s {add = \a b -> if (a, b) `elem` [(1, 2), (2, 1)] then pure 0 else add s a b}),
    Mutant "keeps the first factor" canonicalProfile (\s -> pure s {multiply = \a _ -> pure a}),
    Mutant
      "has one product wrong"
      canonicalProfile
      (\s -> pure s {multiply = \a b -> if (a, b) == (2, 2) then pure 2 else multiply s a b}),
    Mutant "takes an element for its inverse" canonicalProfile (\s -> pure s {inverse = pure}),
    Mutant
      "takes an element for its negative"
      (over 3 [1, 1] [1, 2, 0, 1] (Shape 2 13) (Shape 1 3))
      (\s -> pure s {negation = pure})
  ]

sequenceMutants :: [Mutant]
sequenceMutants =
  [ Mutant "begins one term late" canonicalProfile (\s -> pure s {term = term s . (+ 1)}),
    Mutant
      "runs backwards"
      canonicalProfile
      (\s -> pure s {term = \i -> term s (255 - i `mod` 255)}),
    Mutant
      "ends after a period"
      canonicalProfile
      (\s -> pure s {term = \i -> if i < 255 then term s i else pure 0}),
    Mutant "is zero" canonicalProfile (\s -> pure s {term = const (pure 0)}),
    Mutant "has a short period" canonicalProfile (\s -> pure s {term = term s . (`mod` 17)}),
    Mutant
      "has one term wrong"
      canonicalProfile
      ( \s ->
          pure s {term = \i -> (\a -> if i `mod` 255 == 7 then (a + 1) `mod` 4 else a) <$> term s i}
      ),
    Mutant
      "has 0 and 1 exchanged"
      canonicalProfile
      (\s -> pure s {term = fmap (\a -> if a < 2 then 1 - a else a) . term s})
  ]

arrayMutants :: [Mutant]
arrayMutants =
  [ Mutant
      "has rows and columns exchanged"
      canonicalProfile
      (\s -> pure s {cell = \(Position r c) -> cell s (Position c r)}),
    Mutant
      "packs in one order and unpacks in the other"
      canonicalProfile
      (\s -> pure s {unpack = fmap reverse . unpack s}),
    Mutant "packs one too many" canonicalProfile (\s -> pure s {pack = fmap (+ 1) . pack s}),
    Mutant "unpacks any number" canonicalProfile (\s -> pure s {unpack = unpack s . (`mod` 256)})
  ]

locateMutants :: [Mutant]
locateMutants =
  [ Mutant
      "is one column beside"
      canonicalProfile
      ( \s ->
          pure
            s
              { locate = \cells ->
                  locate s cells >>= \place ->
                    pure
                      ( case place of
                          At (Position r c) -> At (Position r ((c + 1) `mod` 17))
                          other -> other
                      )
              }
      ),
    Mutant
      "knows whole windows only"
      canonicalProfile
      ( \s ->
          pure
            s
              { locate =
                  \cells ->
                    if map length cells == [2, 2]
                      then locate s cells
                      else throwE (Refusal "invalid")
              }
      ),
    Mutant
      "takes zeros for a window"
      canonicalProfile
      ( \s ->
          pure
            s
              { locate = \cells ->
                  locate s cells `catchE` \refusal ->
                    if refusal == Refusal "zero-window"
                      then pure (At (Position 0 0))
                      else throwE refusal
              }
      ),
    Mutant
      "answers anything"
      canonicalProfile
      (\s -> pure s {locate = \cells -> locate s cells `catchE` const (pure (At (Position 0 0)))})
  ]

damageMutants :: [Mutant]
damageMutants =
  [ Mutant
      "takes a cell that was not observed for a 0"
      paper
      (pure . seeing (map (map (Just . fromMaybe 0)))),
    Mutant "looks at the first row only" paper (pure . seeing (take 1)),
    Mutant
      "corrects twice as many cells as are guaranteed"
      paper
      ( \s ->
          pure
            s
              { nearest =
                  \radius rows ->
                    nearest
                      s
                      (Just (fromMaybe (2 * fromIntegral (length (concat rows)) `div` 5) radius))
                      rows
              }
      ),
    Mutant
      "corrects nothing"
      paper
      (\s -> pure s {nearest = \radius -> nearest s (Just (fromMaybe 0 radius))}),
    Mutant
      "corrects one cell less than it is told"
      paper
      ( \s ->
          pure s {nearest = \radius -> nearest s (fmap (\e -> if e == 0 then 0 else e - 1) radius)}
      ),
    Mutant
      "knows a radius for the whole window only, and not for the cells observed"
      paper
      ( \s ->
          pure
            s
              { nearest = \radius rows ->
                  nearest s (radius <|> (if any (elem Nothing) rows then Just 0 else Nothing)) rows
              }
      ),
    Mutant
      "takes the first of several positions"
      paper
      ( \s ->
          pure
            s
              { nearest = \radius rows ->
                  nearest s radius rows >>= \place ->
                    pure
                      ( case place of
                          OneOf (first' : _) -> At first'
                          other -> other
                      )
              }
      ),
    Mutant
      "does not tell how many positions there are"
      paper
      ( \s ->
          pure
            s
              { nearest = \radius rows ->
                  nearest s radius rows >>= \place ->
                    pure
                      ( case place of
                          OneOf _ -> OneOf []
                          other -> other
                      )
              }
      ),
    Mutant
      "takes zeros for a patch like others"
      paper
      ( \s ->
          pure
            s
              { nearest = \radius rows ->
                  nearest s radius rows `catchE` \refusal ->
                    throwE
                      ( if refusal == Refusal "zero-window"
                          then Refusal "beyond-radius"
                          else refusal
                      )
              }
      ),
    Mutant
      "answers what is no patch"
      paper
      ( \s ->
          pure
            s
              { nearest = \radius rows ->
                  nearest s radius rows `catchE` \refusal ->
                    if refusal == Refusal "invalid"
                      then pure (At (Position 0 0))
                      else throwE refusal
              }
      ),
    Mutant
      "goes on beyond the sheet's edge"
      paper {profileSurface = Sheet}
      ( \s -> do
          torus <- opened paper
          pure s {nearest = nearest torus, posterior = posterior torus}
      ),
    Mutant
      "stops at the edge of the torus"
      paper
      ( \s -> do
          sheet <- opened paper {profileSurface = Sheet}
          pure s {nearest = nearest sheet, posterior = posterior sheet}
      ),
    Mutant
      "goes on behind the last column in the next row"
      paper
      ( \s -> do
          twisted <- opened paper {profileSurface = TwistedTorus}
          pure s {nearest = nearest twisted, posterior = posterior twisted}
      ),
    Mutant
      "hears of each cell the likeliest symbol only"
      paper
      ( \s ->
          pure
            s
              { posterior =
                  posterior s
                    . map
                      ( map
                          ( fmap
                              ( \chances ->
                                  [ if chance == maximum chances
                                      then
                                        1
                                          / fromIntegral
                                            (length (filter (== maximum chances) chances))
                                      else 0
                                    | chance <- chances
                                  ]
                              )
                          )
                      )
              }
      ),
    Mutant
      "takes a cell that was not observed for one of symbol 0"
      paper
      (\s -> pure s {posterior = posterior s . map (map (Just . fromMaybe [1, 0, 0, 0]))}),
    Mutant
      "tells likelihoods that do not add up to 1"
      paper
      (\s -> pure s {posterior = fmap (map (fmap (/ 2))) . posterior s}),
    Mutant
      "tells the likeliest position only"
      paper
      (\s -> pure s {posterior = fmap (take 1) . posterior s}),
    Mutant
      "makes probabilities of any numbers"
      paper
      ( \s ->
          pure
            s
              { posterior = \rows ->
                  posterior s rows `catchE` \refusal ->
                    if refusal == Refusal "invalid" then pure [] else throwE refusal
              }
      )
  ]
  where
    paper = canonicalProfile
    seeing rows s = s {nearest = \radius -> nearest s radius . rows}

-- | The profile of these q, modulus, polynomial, shape and window, the rest as in the canonical
-- one.
over :: Natural -> [Natural] -> [Natural] -> Shape -> Shape -> Profile
over q modulus polynomial shape window =
  canonicalProfile
    { profileOrder = q,
      profileModulus = modulus,
      profilePolynomial = polynomial,
      profileState = replicate (length polynomial - 2) 0 ++ [1],
      profileShape = shape,
      profileWindow = window
    }
