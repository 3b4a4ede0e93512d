-- | Which arrays are there? Given an alphabet, the least numbers of rows and columns, and perhaps a
-- window: what is possible, and what is not and why, in order of size. Pseudorandom arrays exist in
-- few sizes, because their cells number q^n - 1, or a divisor of it for several arrays.
module PraTactile.Advise
  ( -- * Asking
    Request (..),
    advise,
    singleArrays,
    AdviceError (..),

    -- * What is possible
    Advice (..),
    Option (..),
    Fit (..),
    Layout (..),
    layoutSurface,
    Mirror (..),

    -- * What is not
    Obstacle (..),
    obstacleDegree,
  )
where

import Data.Bifunctor (first)
import Data.List (sortOn)
import Data.Proxy (Proxy)
import Numeric.Natural (Natural)
import PraTactile.Advise.Fit
import PraTactile.Advise.Layout
import PraTactile.Advise.Neighbours
import PraTactile.Array
import PraTactile.Factorisation
import PraTactile.Field hiding (one)
import PraTactile.Field.Named (conwayModulus)
import PraTactile.Polynomial
import PraTactile.Window

-- | What is wanted.
data Request = Request
  { -- | q, the number of symbols
    requestOrder :: Natural,
    -- | the least number of rows
    requestRows :: Natural,
    -- | the least number of columns
    requestColumns :: Natural,
    -- | the window, or any
    requestWindow :: Maybe Shape
  }
  deriving stock (Eq, Show)

-- | Why there is no advice.
data AdviceError
  = -- | There is no such alphabet.
    AdviceField FieldError
  | -- | The window has no cells.
    AdviceWindowEmpty
  | -- | The window has this many cells, more than windows may have.
    AdviceWindowTooLarge Natural
  | -- | This many cells are wanted, more than 2^128: q^n - 1 might not be factored for want of
    -- time.
    AdviceTooLarge Natural
  deriving stock (Eq, Show)

-- | What there is, and what there is not; both in order of size.
data Advice = Advice
  { -- | what is possible, the fewest cells first
    adviceOptions :: [Option],
    -- | what is not, for the same degrees
    adviceObstacles :: [Obstacle]
  }
  deriving stock (Eq, Show)

-- | Arrays that exist.
data Option = Option
  { -- | the degree n of the primitive polynomial
    optionDegree :: Natural,
    -- | one array or several, and how the sequence is folded
    optionLayout :: Layout,
    -- | the shape of each array
    optionShape :: Shape,
    -- | windows that determine the position, the most nearly square ones first; at least one
    optionFits :: [Fit],
    -- | how many adjacent whole columns there must be before parity checks hold across them;
    -- 'Nothing' where there are not so many
    optionColumnsToCheck :: Maybe Natural,
    -- | the same of rows
    optionRowsToCheck :: Maybe Natural,
    -- | the mirror images of the arrays that are these arrays themselves
    optionMirrors :: [Mirror]
  }
  deriving stock (Eq, Show)

-- | A combination that does not work, and why.
data Obstacle
  = -- | For this degree, q^n - 1, the second number, is not a product of as many rows and columns
    -- as wanted, or more.
    NoSuchShape Natural Natural
  | -- | For this degree, the sides n1 and n2 have a common divisor, so that the diagonal reaches
    -- only a part of the cells and no linear array of the shape exists on the torus; but something
    -- like it does.
    SidesShareDivisor Natural Natural Natural Natural [Option]
  | -- | For this degree n, the window has fewer than n cells, and so fewer contents than there are
    -- positions.
    WindowTooFewCells Natural Shape
  | -- | For this degree, the window is larger than an array of this shape.
    WindowBeyondArray Natural Layout Shape
  | -- | For this degree, the windows of these arrays are not distinct with any of the first
    -- polynomials that were tried, this many.
    WindowFails Natural Layout Shape Int
  | -- | For this degree, q^n - 1 was not factored.
    NotFactored Natural FactorError
  deriving stock (Eq, Show)

-- | The degree for which it stands in the way.
obstacleDegree :: Obstacle -> Natural
obstacleDegree obstacle = case obstacle of
  NoSuchShape n _ -> n
  SidesShareDivisor n _ _ _ _ -> n
  WindowTooFewCells n _ -> n
  WindowBeyondArray n _ _ -> n
  WindowFails n _ _ _ -> n
  NotFactored n _ -> n

-- | What is possible and what is not, from the least degree n with enough terms up to the first
-- that gives one array on a plain torus, or beyond which the window has too few cells; at most 16
-- degrees. Several arrays are listed for a degree only if it gives no single one on a plain torus.
-- Polynomials are over the field with the default modulus. Refuses a q that is no prime power up to
-- 256, a window without cells or with more than 4096, and more than 2^128 cells. For each degree n,
-- q^n - 1 is factored ('factorisePowerMinusOne') and at most 32 polynomials are found; for each
-- shape and window at most as many ranks are taken, as 'PraTactile.Window.Proof.windowRank' does,
-- or for several arrays 'PraTactile.ArrayCode.codeRank'.
advise :: Request -> Either AdviceError Advice
advise request
  | fmap area (requestWindow request) == Just 0 = Left AdviceWindowEmpty
  | Just (Left (WindowTooLarge cells)) <-
      rectangle <$> requestWindow request =
    Left (AdviceWindowTooLarge cells)
  | wantedArea request > 2 ^ (128 :: Int) = Left (AdviceTooLarge (wantedArea request))
  | otherwise = first AdviceField $ do
    (p, modulus) <- conwayModulus q
    withField p modulus (\k -> gather (map (adviseDegree k request) (take 16 [least ..])))
  where
    q = requestOrder request
    least = leastDegree q (wantedArea request)

wantedArea :: Request -> Natural
wantedArea request = max 1 (requestRows request) * max 1 (requestColumns request)

-- | Join the advice for the degrees, up to the first that suffices or beyond which nothing can.
gather :: [Advice] -> Advice
gather degrees =
  Advice (sortOn size (concatMap adviceOptions used)) (concatMap adviceObstacles used)
  where
    used = case break enough degrees of
      (before, after) -> before ++ take 1 after
    enough (Advice options obstacles) =
      or [True | Option {optionLayout = Single Diagonal} <- options]
        || or [True | WindowTooFewCells _ _ <- obstacles]

-- | The fewest cells first, then the fewest rows.
size :: Option -> (Natural, Natural, Layout)
size option = (area (optionShape option), rows (optionShape option), optionLayout option)

-- | The single arrays over GF(q), q the first number, that have at least so many cells, in order of
-- size: of 16 degrees, made as they are asked for. Refuses what 'advise' refuses.
singleArrays :: Natural -> Natural -> Either AdviceError [Option]
singleArrays q cells
  | cells > 2 ^ (128 :: Int) = Left (AdviceTooLarge cells)
  | otherwise = first AdviceField $ do
    (p, modulus) <- conwayModulus q
    withField p modulus (\k -> concatMap (singles . adviseDegree k request) (take 16 [least ..]))
  where
    request = Request q 1 1 Nothing
    least = leastDegree q cells
    singles found = sortOn size [one | one@Option {optionLayout = Single _} <- adviceOptions found]

-- | The degree of the smallest arrays of so many cells.
leastDegree :: Natural -> Natural -> Natural
leastDegree q cells = until (\n -> q ^ n - 1 >= cells) (+ 1) 1

-- | What is possible with the polynomials of a degree, and what is not.
adviseDegree :: KnownField k => Proxy k -> Request -> Natural -> Advice
adviseDegree k request n
  | Just w <- requestWindow request, area w < n = Advice [] [WindowTooFewCells n w]
  | otherwise = case factorisePowerMinusOne (requestOrder request) n of
    Left why -> Advice [] [NotFactored n why]
    Right factors -> adviseShapes (Degree request n (candidates k n) (divisors factors))

-- | What is wanted, and what there is of one degree n.
data Degree k = Degree
  { degreeRequest :: Request,
    -- | n
    degreeNumber :: Natural,
    -- | those that are tried
    degreePolynomials :: [Primitive k],
    -- | of q^n - 1, ascending
    degreeDivisors :: [Natural]
  }

-- | What is possible in arrays of q^n - 1 cells, or of a part of them each, and what is not.
adviseShapes :: KnownField k => Degree k -> Advice
adviseShapes degree@(Degree request n _ ds) =
  Advice
    [option | Right option <- assessed]
    (if null shapes then [NoSuchShape n terms] else shared ++ [why | Left why <- assessed])
  where
    q = requestOrder request
    terms = q ^ n - 1
    shapes = shapesWanted degree terms
    singles =
      [ assess degree layout shape
        | shape <- shapes,
          layout <- [Single Diagonal | coprime shape] ++ [Single RowMajor]
      ]
    joints =
      [ assess degree (Joint g) shape
        | g <- drop 1 ds,
          shape <- shapesWanted degree (terms `div` g),
          coprime shape,
          -- The terms of one of several arrays must still generate all of GF(q^n).
          degreeOfOrder q n (area shape) == n
      ]
    assessed
      | or [True | Right Option {optionLayout = Single Diagonal} <- singles] = singles
      | otherwise = singles ++ joints
    shared =
      [ SidesShareDivisor n n1 n2 (gcd n1 n2) (repairs degree shape)
        | shape@(Shape n1 n2) <- shapes,
          not (coprime shape)
      ]

-- | The shapes of this many cells with as many rows and columns as wanted.
shapesWanted :: Degree k -> Natural -> [Shape]
shapesWanted degree cells =
  [ Shape n1 n2
    | n1 <- degreeDivisors degree,
      cells `mod` n1 == 0,
      let n2 = cells `div` n1,
      n1 >= requestRows (degreeRequest degree),
      n2 >= requestColumns (degreeRequest degree)
  ]

-- | Whether the sides have no common divisor, so that the diagonal reaches all cells.
coprime :: Shape -> Bool
coprime (Shape n1 n2) = gcd n1 n2 == 1

-- | Whether the windows wanted determine the position in these arrays.
assess :: KnownField k => Degree k -> Layout -> Shape -> Either Obstacle Option
assess degree@(Degree request n polynomials _) layout shape = case requestWindow request of
  Nothing -> Right (optionOf degree layout shape (fitting degree layout shape))
  Just w
    | not (w `fitsIn` shape) -> Left (WindowBeyondArray n layout shape)
    | otherwise -> case fits n polynomials (layout, shape) w of
      Right fit -> Right (optionOf degree layout shape [fit])
      Left tried -> Left (WindowFails n layout shape tried)

-- | The arrays of a layout and shape with these windows.
optionOf :: Degree k -> Layout -> Shape -> [Fit] -> Option
optionOf degree layout shape found =
  Option
    { optionDegree = n,
      optionLayout = layout,
      optionShape = shape,
      optionFits = found,
      optionColumnsToCheck = columnsToCheck q n layout shape,
      optionRowsToCheck = rowsToCheck q n layout shape,
      optionMirrors = ownMirrors q n layout shape
    }
  where
    n = degreeNumber degree
    q = requestOrder (degreeRequest degree)

-- | What to do about n1 x n2 whose sides have a common divisor: the most nearly square shape of as
-- many cells on the torus, lying or standing alike; the same shape row by row on the twisted torus;
-- and as few arrays as possible, of parts of the sides. With the window wanted, or where it does
-- not work with others.
repairs :: KnownField k => Degree k -> Shape -> [Option]
repairs degree shape =
  [ optionOf degree layout other found
    | (layout, other) <- instead,
      let asked = wanted layout other
          found = if null asked then fitting degree layout other else asked,
      not (null found)
  ]
  where
    instead =
      take 1 (otherShapes degree shape) ++ [(Single RowMajor, shape)] ++ take 1 (parts degree shape)
    wanted layout other =
      [ fit
        | Just w <- [requestWindow (degreeRequest degree)],
          w `fitsIn` other,
          Right fit <- [fits (degreeNumber degree) (degreePolynomials degree) (layout, other) w]
      ]

-- | Shapes of as many cells with coprime sides, the most nearly square ones first.
otherShapes :: Degree k -> Shape -> [(Layout, Shape)]
otherShapes degree shape =
  sortOn
    (\(_, Shape a b) -> max a b)
    [ (Single Diagonal, Shape a b)
      | a <- degreeDivisors degree,
        let b = area shape `div` a,
        a > 1,
        b > 1,
        coprime (Shape a b),
        (a <= b) == (rows shape <= columns shape)
    ]

-- | Several arrays of parts of the sides, the fewest arrays first.
parts :: Degree k -> Shape -> [(Layout, Shape)]
parts (Degree request n _ ds) shape@(Shape n1 n2) =
  sortOn
    (\(_, Shape a b) -> (area shape `div` (a * b), n1 `div` a))
    [ (Joint (area shape `div` (a * b)), Shape a b)
      | a <- ds,
        a > 1,
        n1 `mod` a == 0,
        b <- ds,
        b > 1,
        n2 `mod` b == 0,
        coprime (Shape a b),
        degreeOfOrder (requestOrder request) n (a * b) == n
    ]

-- | The windows of n cells that determine the position in these arrays, the most nearly square ones
-- first.
fitting :: KnownField k => Degree k -> Layout -> Shape -> [Fit]
fitting (Degree _ n polynomials _) layout shape =
  [fit | w <- windowsOf n, w `fitsIn` shape, Right fit <- [fits n polynomials (layout, shape) w]]

-- | All rectangles of n cells, the most nearly square ones first.
windowsOf :: Natural -> [Shape]
windowsOf n = sortOn squareness [Shape k1 (n `div` k1) | k1 <- [1 .. n], n `mod` k1 == 0]
  where
    squareness w = (max (rows w) (columns w), columns w)
