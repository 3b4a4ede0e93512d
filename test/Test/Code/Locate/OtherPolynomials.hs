-- | The arrays that are as one, by every other primitive polynomial, as these are found one by one.
module Test.Code.Locate.OtherPolynomials
  ( byOtherPolynomials,
    worth,
  )
where

import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid (displaced)
import PraTactile.Polynomial
import PraTactile.Sequence
import PraTactile.Symmetry

-- | Of the same folding and shape, each beginning with s(0), s(r), s(2 r), ... for the least r for
-- which that is a sequence of its polynomial.
byOtherPolynomials :: KnownField k => PseudorandomArray k -> [PseudorandomArray k]
byOtherPolynomials array =
  [ other
    | Right found <- [primitivePolynomials (fromIntegral n)],
      h <- found,
      h /= arrayPrimitive array,
      terms : _ <-
        [[terms | terms <- decimated, Right state <- [start h terms], obeys h state terms]],
      Right state <- [start h terms],
      Right other <- [fold (arrayFolding array) (arrayShape array) h state]
  ]
  where
    n = primitiveDegree (arrayPrimitive array)
    size = period (arrayPrimitive array)
    decimated =
      [ [cellAt array (positionOfIndex array (r * i)) | i <- take (2 * n + 1) [0 ..]]
        | r <- [2 .. size - 1],
          gcd r size == 1
      ]
    start h terms = initialState h (take n terms)
    obeys h state terms = take (2 * n + 1) (mSequence h state) == terms

-- | The sum over all symmetries and positions, with which the cells lie on the surface, of the
-- product of what the cells give to the symbols there, and how many such pairs there are. Cells are
-- given by their offsets as they are seen, in a patch of this shape, each with what it gives.
worth ::
  KnownField k =>
  ArrayOn k ->
  [Symmetry] ->
  Shape ->
  [(Position, Symmetry -> GF k -> Double)] ->
  (Double, Natural)
worth (ArrayOn surface array) possible shape cells =
  (sum products, fromIntegral (length products))
  where
    products =
      [ product (zipWith (\(_, gives) at -> gives o (cellAt array at)) cells places)
        | o <- possible,
          let uprightCells = [onPosition (invert o) shape at | (at, _) <- cells],
          position <- shapeCells (arrayShape array),
          Just places <- [traverse (displaced surface (arrayShape array) position) uprightCells]
      ]
