{-# LANGUAGE GADTs #-}

-- | The smaller questions that a failing one is tried with: of the same operation, with smaller
-- numbers, fewer cells, and less in them.
module PraTactile.Conformance.Laws.Smaller
  ( smaller,
    smallerNatural,
    smallerList,
    smallerPatch,
  )
where

import Data.List (transpose)
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (Shape))
import PraTactile.Conformance.Question
import PraTactile.Object.Description (Description (..), FaceName (..), Point (..))
import Test.QuickCheck (shrinkIntegral)

-- | The smaller questions, the smallest first. A raw one has none, and neither has one about
-- frames, whose scene is made smaller instead.
smaller :: SomeQuestion -> [SomeQuestion]
smaller (SomeQuestion question) = case question of
  Add a b -> [SomeQuestion (Add c d) | (c, d) <- pairs a b]
  Multiply a b -> [SomeQuestion (Multiply c d) | (c, d) <- pairs a b]
  Negate a -> SomeQuestion . Negate <$> smallerNatural a
  Inverse a -> SomeQuestion . Inverse <$> smallerNatural a
  Power a i ->
    [SomeQuestion (Power b i) | b <- smallerNatural a]
      ++ [SomeQuestion (Power a j) | j <- shrinkIntegral i]
  Logarithm a -> SomeQuestion . Logarithm <$> smallerNatural a
  Trace a -> SomeQuestion . Trace <$> smallerNatural a
  Primitive codes -> SomeQuestion . Primitive <$> filter proper (smallerList smallerNatural codes)
  FirstPrimitive n -> SomeQuestion . FirstPrimitive <$> smallerNatural n
  Term i -> SomeQuestion . Term <$> smallerNatural i
  Terms i count -> [SomeQuestion (Terms j less) | (j, less) <- pairs i count]
  Cell r c -> [SomeQuestion (Cell r' c') | (r', c') <- pairs r c]
  Pack codes -> SomeQuestion . Pack <$> each smallerNatural codes
  Unpack n -> SomeQuestion . Unpack <$> smallerNatural n
  Locate rows -> SomeQuestion . Locate <$> smallerPatch observed rows
  Nearest radius rows ->
    [SomeQuestion (Nearest radius less) | less <- smallerPatch observed rows]
      ++ [SomeQuestion (Nearest (Just e) rows) | Just e <- [radius] >>= traverse smallerNatural]
  Posterior rows -> SomeQuestion . Posterior <$> smallerPatch chance rows
  Prove mask -> SomeQuestion . Prove <$> smallerMask mask
  Distance mask -> SomeQuestion . Distance <$> smallerMask mask
  SolidReport it -> SomeQuestion . SolidReport <$> smallerSolid it
  FaceCells corners pitch ->
    [SomeQuestion (FaceCells less pitch) | less <- smallerList simpler corners]
  Whereabouts mapped (Shape high wide) (Position r c) ->
    [ SomeQuestion (Whereabouts mapped {mappedLayings = less} (Shape high wide) (Position r c))
      | less <- smallerList (const []) (mappedLayings mapped)
    ]
      ++ [ SomeQuestion (Whereabouts mapped (Shape high' wide') (Position r c))
           | (high', wide') <- pairs high wide,
             high' > 0 && wide' > 0
         ]
      ++ [ SomeQuestion (Whereabouts mapped (Shape high wide) (Position r' c'))
           | (r', c') <-
               pairs r c
         ]
  FacePose felt ->
    [SomeQuestion (FacePose felt {feltPlane = Nothing}) | Just _ <- [feltPlane felt]]
      ++ [ SomeQuestion (FacePose felt {feltSeen = less})
           | less <- smallerList (const []) (feltSeen felt),
             length less > 1
         ]
  Outputs weights rows -> [SomeQuestion (Outputs less rows) | less <- smallerNetwork weights]
  _ -> []
  where
    pairs a b = [(c, b) | c <- smallerNatural a] ++ [(a, d) | d <- smallerNatural b]
    -- One that ends in 0 states no degree.
    proper codes = not (null codes) && last codes /= 0

-- | Without one of the faces, without the vertices that no face has, or with simpler coordinates.
smallerSolid :: Description -> [Description]
smallerSolid it =
  [it {describedFaces = less} | less <- smallerList (const []) (describedFaces it)]
    ++ [it {describedVertices = used} | length used < length (describedVertices it)]
    ++ [it {describedVertices = less} | less <- each (traverse simpler) (describedVertices it)]
  where
    used = filter ((`elem` concatMap faceVertices (describedFaces it)) . fst) (describedVertices it)

-- | Without one of the hidden units, or without the last output unit.
smallerNetwork :: Weights -> [Weights]
smallerNetwork (Weights hidden output) =
  [ Weights (without j hidden) (map (without j) output)
    | length hidden > 1,
      j <- [0 .. length hidden - 1]
  ]
    ++ [Weights hidden (init output) | length output > 1]
  where
    without j xs = take j xs ++ drop (j + 1) xs

-- | A point with whole coordinates.
simpler :: Point -> [Point]
simpler p@(Point x y z) = filter (/= p) [Point (whole x) (whole y) (whole z)]
  where
    whole = fromInteger . round

observed :: Maybe Code -> [Maybe Code]
observed cell = case cell of
  Nothing -> []
  Just code -> Nothing : map Just (smallerNatural code)

chance :: Chance -> [Chance]
chance known = case known of
  Unfelt -> []
  Certainly code -> Unfelt : map Certainly (smallerNatural code)
  Probably chances ->
    Unfelt : [Certainly (fromIntegral i) | (i, x) <- zip [0 :: Int ..] chances, x > 0]

-- | Towards 0, the largest step first.
smallerNatural :: Natural -> [Natural]
smallerNatural n = [fromInteger i | i <- shrinkIntegral (toInteger n), i >= 0]

-- | One element less, from either end, or one of them smaller.
smallerList :: (a -> [a]) -> [a] -> [[a]]
smallerList less xs = fewer xs ++ each less xs

-- | One row or column less, or one of the cells with less in it.
smallerPatch :: (a -> [a]) -> [[a]] -> [[[a]]]
smallerPatch less rows =
  filter (any (not . null)) (fewer rows ++ map transpose (fewer (transpose rows)))
    ++ each (each less) rows

smallerMask :: MaskRows -> [MaskRows]
smallerMask = filter (any (elem '#')) . smallerPatch (\mark -> ['.' | mark == '#'])

-- | Without the first, and without the last.
fewer :: [a] -> [[a]]
fewer xs = case xs of
  [] -> []
  [_] -> []
  _ : rest -> [rest, init xs]

-- | With one of them smaller.
each :: (a -> [a]) -> [a] -> [[a]]
each less xs =
  [ before ++ x' : after | (before, x : after) <- map (`splitAt` xs) [0 .. length xs - 1], x' <-
                                                                                             less x
  ]
