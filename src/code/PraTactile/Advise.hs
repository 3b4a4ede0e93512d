-- | Advice on which arrays exist. Given an alphabet, the least numbers of rows and columns, and
-- perhaps a window, it lists in order of size what is possible, and what is not and why.
-- Pseudorandom arrays exist only in few sizes, because they have q^n - 1 cells, or several arrays
-- each have a divisor of that.
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

-- | The arrays that are wanted.
data Request = Request
  { -- | q, the number of symbols
    requestOrder :: Natural,
    -- | the least number of rows
    requestRows :: Natural,
    -- | the least number of columns
    requestColumns :: Natural,
    -- | the window, or 'Nothing' for any
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
  | -- | This many cells are wanted, more than 2^128, for which factoring q^n - 1 might take too
    -- long.
    AdviceTooLarge Natural
  deriving stock (Eq, Show)

-- | What is possible and what is not.
data Advice = Advice
  { -- | what is possible, by the cells of one array, the fewest first
    adviceOptions :: [Option],
    -- | what is not possible, for the same degrees, by degree
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
    -- | the least number of adjacent whole columns that satisfy a parity check together, and not
    -- only each by itself; 'Nothing' if the array has fewer
    optionColumnsToCheck :: Maybe Natural,
    -- | the least number of adjacent whole rows that satisfy a parity check together; 'Nothing' if
    -- the array has fewer
    optionRowsToCheck :: Maybe Natural,
    -- | the mirror images that equal the arrays themselves, shifted on the layout's surface
    optionMirrors :: [Mirror]
  }
  deriving stock (Eq, Show)

-- | A combination that does not work, and why.
data Obstacle
  = -- | For this degree, q^n - 1, the second number, is not a product of at least the wanted rows
    -- and columns.
    NoSuchShape Natural Natural
  | -- | For this degree, the sides n1 and n2 have a common divisor; the fourth number is the
    -- greatest one. So the diagonal reaches only some of the cells, and no linear array of the
    -- shape exists on the torus. The options are alternatives. They may have fewer rows or columns
    -- than wanted, or other windows if the wanted one fails.
    SidesShareDivisor Natural Natural Natural Natural [Option]
  | -- | For this degree n, the window has fewer than n cells, so there are fewer contents than
    -- positions.
    WindowTooFewCells Natural Shape
  | -- | For this degree, the window is larger than an array of this shape.
    WindowBeyondArray Natural Layout Shape
  | -- | For this degree, the windows of these arrays are not distinct for any of the polynomials
    -- that were tried; the last number is how many.
    WindowFails Natural Layout Shape Int
  | -- | For this degree, q^n - 1 was not factored.
    NotFactored Natural FactorError
  deriving stock (Eq, Show)

-- | The degree that an obstacle is about.
obstacleDegree :: Obstacle -> Natural
obstacleDegree obstacle = case obstacle of
  NoSuchShape n _ -> n
  SidesShareDivisor n _ _ _ _ -> n
  WindowTooFewCells n _ -> n
  WindowBeyondArray n _ _ -> n
  WindowFails n _ _ _ -> n
  NotFactored n _ -> n

-- | Lists what is possible and what is not. Degrees n run from the least one with enough terms to
-- the first one that gives a single array on a plain torus, or for which the window has too few
-- cells; at most 16 degrees. Codes of several arrays are listed for a degree only if it gives no
-- single array on a plain torus. Polynomials are over the field with the default modulus.
--
-- Refuses a q that is not a prime power up to 256, a window without cells or with more than 4096,
-- and more than 2^128 cells. For each degree n, q^n - 1 is factored ('factorisePowerMinusOne') and
-- at most 32 polynomials are found. For each shape and window, at most that many ranks are
-- computed, by 'PraTactile.Window.Proof.windowRank', or for several arrays
-- 'PraTactile.ArrayCode.codeRank'.
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

-- | Joins the advice of the degrees, up to the first that suffices or beyond which nothing can.
gather :: [Advice] -> Advice
gather degrees =
  Advice (sortOn size (concatMap adviceOptions used)) (concatMap adviceObstacles used)
  where
    used = case break enough degrees of
      (before, after) -> before ++ take 1 after
    enough (Advice options obstacles) =
      or [True | Option {optionLayout = Single Diagonal} <- options]
        || or [True | WindowTooFewCells _ _ <- obstacles]

-- | The sort key: cells first, then rows.
size :: Option -> (Natural, Natural, Layout)
size option = (area (optionShape option), rows (optionShape option), optionLayout option)

-- | The single arrays over GF(q) with at least the given number of cells, in order of size, for 16
-- degrees, computed lazily. The first argument is q. Refuses what 'advise' refuses.
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

-- | The degree of the smallest arrays with at least this many cells over GF(q).
leastDegree :: Natural -> Natural -> Natural
leastDegree q cells = until (\n -> q ^ n - 1 >= cells) (+ 1) 1

-- | The advice for the polynomials of one degree.
adviseDegree :: KnownField k => Proxy k -> Request -> Natural -> Advice
adviseDegree k request n
  | Just w <- requestWindow request, area w < n = Advice [] [WindowTooFewCells n w]
  | otherwise = case factorisePowerMinusOne (requestOrder request) n of
    Left why -> Advice [] [NotFactored n why]
    Right factors -> adviseShapes (Degree request n (candidates k n) (divisors factors))

-- | The request, and the data for one degree n.
data Degree k = Degree
  { degreeRequest :: Request,
    -- | n
    degreeNumber :: Natural,
    -- | the polynomials that are tried
    degreePolynomials :: [Primitive k],
    -- | the divisors of q^n - 1, ascending
    degreeDivisors :: [Natural]
  }

-- | The advice for single arrays of q^n - 1 cells, and for several arrays that share them.
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

-- | The shapes with this many cells and at least the wanted rows and columns.
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

-- | Whether the wanted windows determine the position in these arrays.
assess :: KnownField k => Degree k -> Layout -> Shape -> Either Obstacle Option
assess degree@(Degree request n polynomials _) layout shape = case requestWindow request of
  Nothing -> Right (optionOf degree layout shape (fitting degree layout shape))
  Just w
    | not (w `fitsIn` shape) -> Left (WindowBeyondArray n layout shape)
    | otherwise -> case fits n polynomials (layout, shape) w of
      Right fit -> Right (optionOf degree layout shape [fit])
      Left tried -> Left (WindowFails n layout shape tried)

-- | The option for arrays of a layout and shape with these windows.
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

-- | Alternatives for n1 x n2 cells whose sides have a common divisor: the most nearly square shapes
-- with as many cells on the torus; the same shape row by row on the twisted torus; and as few
-- arrays as possible whose sides divide n1 and n2. They have the wanted window or, if it does not
-- work, others.
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

-- | Shapes with as many cells and coprime sides, the most nearly square ones first.
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

-- | Several arrays whose sides divide those of the shape, the fewest arrays first.
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
