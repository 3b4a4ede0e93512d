-- | The kinds of images that reach the classifier: upright symbols, and impostors that it must not
-- take for one.
module PraTactile.Classification.Specimens
  ( SpecimenKind (..),
    genuine,
    impostors,
    specimen,
    misplacementBound,
  )
where

import PraTactile.Classification.Samples
import PraTactile.Image (Raster)
import PraTactile.Random (uniform)
import PraTactile.Shape
import PraTactile.Shape.Distance (Feature (Full), ordinaryFeatures)
import System.Random (StdGen)

-- | What an image shows.
data SpecimenKind
  = -- | A symbol, upright and in place.
    Upright
  | -- | An upright symbol in place, of which a corner at most 3 taxels wide or tall, or a margin
    -- of at most 2, was not observed.
    Curtailed
  | -- | A symbol turned by 180 degrees.
    UpsideDown
  | -- | A symbol turned by 180 degrees, of which a corner at most 4 taxels wide or tall, or a
    -- margin of at most 2, was not observed.
    CurtailedUpsideDown
  | -- | A symbol turned by 90 degrees.
    Sideways
  | -- | A symbol displaced by 3 to 6 taxels in at least one direction.
    Displaced
  | -- | One half of a symbol and the other half of another.
    Halves
  | -- | An ordinary feature of an object: edge, ridge, corner, disc, or a raised plateau.
    Ordinary
  | -- | A flat face.
    Bare
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | Whether a kind is an upright symbol in place, so that its class is the right answer.
genuine :: SpecimenKind -> Bool
genuine kind = kind == Upright || kind == Curtailed

-- | The kinds for which every class is a wrong answer.
impostors :: [SpecimenKind]
impostors = filter (not . genuine) [minBound .. maxBound]

-- | The displacement, in taxels in each direction, up to which a symbol in its 8 x 12 image must
-- still be recognised.
misplacementBound :: Double
misplacementBound = 0.7

-- | The noiseless image of a random specimen of a kind, as stitching and segmentation would leave
-- it, and the next generator. Arguments: the alphabet; the kind; the shape; a generator. A kind
-- that needs two shapes takes another one from the alphabet.
specimen :: Alphabet -> SpecimenKind -> Bitmap -> StdGen -> (Raster, StdGen)
specimen alphabetOfAll kind shape g = case kind of
  Upright -> (see view (symbolScene shape), g')
  Curtailed -> curtailed 3 (see view (symbolScene shape)) g'
  CurtailedUpsideDown -> curtailed 4 (see view (symbolScene (halfTurned shape))) g'
  UpsideDown -> (see view (symbolScene (halfTurned shape)), g')
  Sideways -> (see view (sidewaysScene shape), g')
  Displaced ->
    let (far, h) = offset g'
        (near, h') = between (-6) 6 h
        (rows, h'') = below 2 h'
     in ( see view {viewShift = if rows == 0 then (far, near) else (near, far)} (symbolScene shape),
          h''
        )
  Halves ->
    let (other, h) = oneOf shape (filter (/= shape) (shapes alphabetOfAll)) g'
        (cut, h') = below 2 h
     in (see view ((if cut == 0 then besideScene else overScene) shape other), h')
  Ordinary ->
    let (feature, h) = oneOf Full ordinaryFeatures g'
     in (see view (featureScene feature), h)
  Bare -> (see view flatScene, g')
  where
    (view, g') = stitchedView misplacementBound g
    offset h =
      let (size, h') = between 3 6 h
          (side, h'') = below 2 h'
       in (if side == 0 then size else -size, h'')

-- | The image with a random part unseen: a corner, or 1 or 2 columns or rows at an edge. The number
-- is the greatest width of a tall corner, and the greatest height of a wide one. Also the next
-- generator.
curtailed :: Int -> Raster -> StdGen -> (Raster, StdGen)
curtailed thickest image g0 = (withUnseen unseen image, g5)
  where
    (sort, g1) = below 4 g0
    (u, g2) = below 2 g1
    (v, g3) = below 2 g2
    (thin, g4) = below thickest g3
    (long, g5) = below symbolHeight g4
    far = u == 1
    unseen
      | sort == 0 = inCorner (thin + 1) (long + 1)
      | sort == 1 = inCorner (1 + long * symbolWidth `div` symbolHeight) (thin + 1)
      | sort == 2 = ColumnsUnseen far (v + 1)
      | otherwise = RowsUnseen far (v + 1)
    inCorner width height =
      CornerUnseen
        Corner
          { cornerAtRight = far,
            cornerAtBottom = v == 1,
            cornerWidth = width,
            cornerHeight = height
          }

-- | A uniform number between two bounds, and the next generator.
between :: Double -> Double -> StdGen -> (Double, StdGen)
between low high g = let (u, g') = uniform g in (low + (high - low) * u, g')

-- | A uniform integer from 0 to n - 1, for this n, and the next generator.
below :: Int -> StdGen -> (Int, StdGen)
below n g = let (u, g') = uniform g in (floor (u * fromIntegral n), g')

-- | A uniformly drawn element of the list, or the first argument if the list is empty; and the next
-- generator.
oneOf :: a -> [a] -> StdGen -> (a, StdGen)
oneOf none list g = let (i, g') = below (length list) g in (foldr const none (drop i list), g')
