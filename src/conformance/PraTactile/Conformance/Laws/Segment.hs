{-# OPTIONS_HADDOCK hide #-}

-- | The laws of segmentation: drawn symbols are found where they were drawn, along their own axes,
-- and nothing else is.
module PraTactile.Conformance.Laws.Segment
  ( segmentLaws,
  )
where

import PraTactile.Conformance.Ask
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Drawing
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Malformed
import PraTactile.Conformance.Laws.Relief
import PraTactile.Conformance.Question
import PraTactile.Symmetry (degreesClockwise, onPixel, onRows, turned)

-- | The laws of segmentation.
segmentLaws :: [Law ()]
segmentLaws =
  [ comesOut
      "drawn-symbols"
      "exactly the drawn symbols are found, their centres to half a pixel and their axes to 5 \
      \degrees"
      "they were drawn there"
      upright,
    comesOut
      "off-the-lattice"
      "symbols that do not lie on a lattice are found where they lie"
      "they were drawn there"
      ( \drawing ->
          let n = drawingChange drawing
              by c r =
                let k = toInteger (n * 7 + c * 5 + r * 11) in (k `mod` 3, k `div` 3 `mod` 3)
              (rows, centres) = drawn drawing (symbolsOf by drawing)
           in (rows, [Symbol centre 0 | centre <- centres])
      ),
    comesOut
      "turned"
      "turning a composite by quarter turns turns its symbols and axes by as much"
      "they belong to the scene, whichever way it is seen"
      ( \drawing ->
          let (rows, symbols) = upright drawing
              symmetry = turned (1 + drawingChange drawing `mod` 3)
              size = (fromIntegral (length (concat (take 1 rows))), fromIntegral (length rows))
           in ( onRows symmetry rows,
                [ Symbol (onPixel symmetry size place) (degrees + degreesClockwise symmetry)
                  | Symbol place degrees <- symbols
                ]
              )
      ),
    comesOutOf
      (Some genBlock smallerBlock)
      "turned-by-degrees"
      "the symbols of a face at any angle are found at that angle, in their places and axes"
      "they belong to the scene, whichever way it is seen"
      atAngle,
    comesOut
      "gain-and-offset"
      "a gain and an offset of all grey values change nothing"
      "gain and offset of grey values are not relief"
      ( \drawing ->
          let (rows, symbols) = upright drawing
              n = drawingChange drawing
              change = Affine (fromIntegral (1 + n `mod` 3)) (fromIntegral (n * 5))
           in (affinely change rows, symbols)
      ),
    comesOut
      "blank"
      "a blank composite has no symbols"
      "a composite of one grey value shows nothing"
      ( \drawing ->
          let (rows, _) = upright drawing
           in (map (map (const (fromIntegral (60 * drawingChange drawing)))) rows, [])
      ),
    comesOut
      "cut-off"
      "symbols cut off by the composite's edge are not found, and the others are"
      "three of their columns or more were not touched"
      ( \drawing ->
          let (rows, symbols) = upright drawing
              less = fst (drawingOrigin drawing) + 3 + toInteger (drawingChange drawing `mod` 3)
           in ( map (drop (fromInteger less)) rows,
                [ Symbol (x - fromInteger less, y) degrees
                  | Symbol (x, y) degrees <- symbols,
                    x - 3.5 >= fromInteger less
                ]
              )
      ),
    invalidLaw
  ]

-- | A law that exactly the given symbols are found in a drawing's composite.
comesOut :: String -> String -> String -> (Drawing -> (Rows, [Symbol])) -> Law ()
comesOut = comesOutOf (Some genDrawing smallerDrawing)

-- | 'comesOut' for the given drawings.
comesOutOf ::
  Domain Drawing -> String -> String -> String -> (Drawing -> (Rows, [Symbol])) -> Law ()
comesOutOf drawings what sentence reason scene =
  law OnSegment what [SomeOp Segment] sentence "how it was drawn; the protocol, segment" $ \() ->
    Cases drawingForm drawings $ \drawing ->
      let (rows, wanted) = scene drawing
          question = Segment :? rows
          fits got = length got == length wanted && all (\one -> any (same one) got) wanted
       in judge question (Right wanted) fits "the scene" reason <$> ask question
  where
    same (Symbol (x, y) a) (Symbol (x', y') a') =
      max (abs (x - x')) (abs (y - y')) <= 0.5 && apart a a' <= 5
    -- Axes are compared up to half turns.
    apart a a' =
      let difference = abs (a - a')
          turns = fromIntegral (floor (difference / 180) :: Integer)
          d = difference - 180 * turns
       in min d (180 - d)

invalidLaw :: Law ()
invalidLaw =
  invalid OnSegment "refuses-what-is-invalid" Segment $ \() ->
    [ SomeQuestion (Segment :? rows)
      | rows <-
          [ [],
            [[]],
            replicate 20 (replicate 20 0) ++ [[0]],
            replicate 20 (replicate 20 (fullScale + 1))
          ]
    ]
      ++ malformed (Segment :? replicate 20 (replicate 20 1))
