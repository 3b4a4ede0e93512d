{-# LANGUAGE BangPatterns #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Estimates how a face lies under frames, from all their pixels. The known relief of the face is
-- aligned with what each frame felt.
--
-- Pixel u of frame f, measured from the frame's centre, reads
--
-- > I_f(u) = o_f + g_f S(q) + noise of variance v_f
-- > q = R(-a) (m_f + e_f + R(r_f) u - t)
--
-- where S is the blurred relief of the face ('heightAt'), and (t, a) the motion of the face
-- ("PraTactile.Pose"). The robot puts the centre of the frame at m_f and errs by e_f in place and
-- r_f in rotation. The frame has offset o_f and gain g_f. A priori e_f is normal with standard
-- deviation s along each axis, r_f with standard deviation r, and o_f and g_f lie near those of all
-- frames.
--
-- Let x = (t, a), about a pivot c, and y_f = (e_f, r_f, o_f, g_f). The method of Gauss and Newton
-- uses, for each frame, a normal matrix of both, which includes the prior information on y_f, and
-- gradients (k_f, l_f):
--
-- > | X_f    Z_f |
-- > | Z_f^T  Y_f |
-- >
-- > M  = sum X_f - Z_f Y_f^-1 Z_f^T
-- > dx = M^-1 sum (k_f - Z_f Y_f^-1 l_f)         dy_f = Y_f^-1 (l_f - Z_f^T dx)
--
-- So M^-1 is the covariance of x after all y_f are marginalised. It includes the mean error of all
-- frames: if the frames were read without error, it would be s^2 / N and r^2 / N.
--
-- The noise variances come from the residuals d_i. The noise is not uniform: clipped readings err
-- less where the relief is flat, and flat places do not affect the motion. What matters is the
-- error of the gradients, whose variance is the sum of a_i^2 times the variance of pixel i; a_i is
-- the slope of the relief there (White, Econometrica 48, 1980). Hence
--
-- > v_f = sum a_i^2 d_i^2 / sum a_i^2 (1 - h_i)       h_i = b_i^T Y_f^-1 b_i / v_f
--
-- where b_i is the derivative of pixel i by y_f, and h_i its leverage (MacKinnon and White, Journal
-- of Econometrics 29, 1985). The unknown r^2 is the mean of r_f^2 + var r_f (expectation
-- maximisation), where var y_f = Y_f^-1 + Y_f^-1 Z_f^T M^-1 Z_f Y_f^-1.
--
-- = Errors that are not white noise
--
-- Tilt, hysteresis and gain variations give the pixels of a frame errors in common. Also, the
-- normal blur is not the square aperture of a noiseless sensor. If the model were right, the
-- covariances of the frames' final scores s_f = k_f - Z_f Y_f^-1 l_f would add up to M. So M^-1 is
-- multiplied by the dispersion of the scores if that is above 1 (the quasi-likelihood of
-- Wedderburn, Biometrika 61, 1974, with the N frames as independent observations):
--
-- > N / (N - 1) sum s_f^T M^-1 s_f / 3
--
-- The dispersion misses errors that all frames at one place share. Without noise (@ideal@) the 95 %
-- region contained the truth in 51 of 60 presses, and the 50 % region in 46; the errors are a few
-- micrometres.
module PraTactile.Pose.Alignment
  ( Ground (..),
    heightAt,
    Touch (..),
    aligned,
  )
where

import Data.List (foldl', transpose)
import qualified Data.Map.Strict as Map
import qualified Data.Vector.Unboxed as U
import PraTactile.Geometry
  ( columnPitch,
    cosineSine,
    rotated,
    rowPitch,
    symbolHeight,
    symbolWidth,
    toDegrees,
    toRadians,
  )
import PraTactile.Pose
import PraTactile.Pose.Matrix
import PraTactile.Sensor.Frame (Motion (..), movePoint)
import qualified PraTactile.Sensor.Frame as Frame
import PraTactile.Shape (Bitmap, embossedAt)
import PraTactile.Shape.Blur (blurredAt, blurredSlope)

-- | The known symbols of a face by row and column, and the upper left corner of their cell (0, 0),
-- in taxels from the face's first vertex.
data Ground = Ground
  { groundCorner :: !(Double, Double),
    groundShapes :: !(Map.Map (Int, Int) Bitmap)
  }

-- | The standard deviation of the blur, in taxels: that of an element's aperture, one taxel wide.
blur :: Double
blur = 0.3

-- | The height of the blurred relief at a place of the face, 1 at the top of a symbol, and its
-- slopes to the right and down. 'Nothing' if the symbol there is unknown. Neighbouring cells
-- contribute nothing, since half the pitch lies between symbols.
heightAt :: Ground -> (Double, Double) -> Maybe (Double, Double, Double)
heightAt (Ground (left, top) known) (x, y) =
  (\shape -> height shape u v) <$> Map.lookup (i, j) known
  where
    (j, u) = within columnPitch symbolWidth (x - left)
    (i, v) = within rowPitch symbolHeight (y - top)
    -- The cell, and the place relative to the upper left corner of its symbol.
    within pitch side t =
      let cell = floor (t / pitch) :: Int
       in (cell, t - pitch * fromIntegral cell - (pitch - fromIntegral side) / 2)

-- | The height and slopes of a shape at a place relative to its upper left corner. Each taxel
-- contributes the product of a share to the right and a share down.
height :: Bitmap -> Double -> Double -> (Double, Double, Double)
height shape u v = down 0 0 0 (near symbolHeight v)
  where
    columns = near symbolWidth u
    down !a !b !c rows = case rows of
      Near j share slope : others -> across a b c columns
        where
          across !a' !b' !c' ahead = case ahead of
            Near i share' slope' : further
              | embossedAt shape i j ->
                across (a' + share * share') (b' + share * slope') (c' + slope * share') further
              | otherwise -> across a' b' c' further
            [] -> down a' b' c' others
      [] -> (a, b, c)
    near side t =
      let k = floor t
       in [ Near n (blurredAt blur from) (blurredSlope blur from)
            | n <- [max 0 (k - 2) .. min (side - 1) (k + 2)],
              let from = t - fromIntegral n - 0.5
          ]

-- | A column or row of taxels near a place: its index, its share of the height there, and the slope
-- of that share.
data Near = Near !Int !Double !Double

-- | A frame, in taxels of the grid on which the motion is estimated.
data Touch = Touch
  { -- | its centre, as the robot has it
    touchMiddle :: !(Double, Double),
    -- | its displacement from there
    touchMoved :: !(Double, Double),
    -- | the prior standard deviations of its place, in taxels, and of its rotation, in degrees;
    -- 'Nothing' if that of the rotation is to be estimated
    touchErrors :: !(Double, Maybe Double),
    -- | each pixel that was felt: its place relative to the centre, and its reading
    touchPixels :: !(U.Vector (Double, Double, Double))
  }

-- | A frame's own parameters: the list e, r in radians, o and g; and the noise variance v.
data Own = Own ![Double] !Double

-- | Finds the motion from the face's frame to the grid, near the given one, and its errors.
-- 'Nothing' if fewer than 'leastPixels' pixels were felt, or if the result is further from the
-- given motion than reading symbols can be wrong: 3 taxels or 15 degrees.
aligned :: Ground -> [Touch] -> Motion -> Maybe PlaneFit
aligned ground touches begin
  | sum (map (U.length . touchPixels) touches) < leastPixels = Nothing
  | otherwise = go (15 :: Int) (begin, rotationPrior, map start touches)
  where
    start touch =
      let (x, y) = touchMoved touch in Own [x, y, 0, 0, strongest] (strongest * strongest / 100)
    strongest = maximum (map (U.foldl' (\m (_, _, value) -> max m value) 0 . touchPixels) touches)
    (count, sumX, sumY) = foldl' middle (0, 0, 0) touches
    middle (n, a, b) (Touch (x, y) _ _ pixels) =
      let k = fromIntegral (U.length pixels) in (n + k, a + k * x, b + k * y)
    pivot = (sumX / count, sumY / count) :: (Double, Double)
    go n (motion, r, owns) = do
      let parts =
            [ normalOf (ownPrior r strongest (meanOf owns) touch) own $
                pixelsOn ground pivot motion touch own
              | (touch, own) <- zip touches owns
            ]
      solved <- traverse (eliminated (1e-6 * strongest * strongest)) parts
      covariance <- inverse (foldr (plus . reducedRows) (diagonal [0, 0, 0]) solved)
      let dx = covariance `applied` foldr (zipWith (+) . reducedGradient) [0, 0, 0] solved
          next = [updated dx part own | (part, own) <- zip solved owns]
          r' = rotationAmong touches next (map (rotationVariance covariance) solved)
          now = (nudged pivot dx motion, r', next)
      case now of
        (motion', _, _)
          | not (near motion') -> Nothing
          | n <= 1 || (small dx && abs (r' - r) < 0.02 * r) ->
            Just (PlaneFit motion' pivot (scaled (dispersion covariance solved) covariance))
          | otherwise -> go (n - 1) now
    small = (< 1e-5) . maximum . zipWith (\scale v -> scale * abs v) [1, 1, 20]
    meanOf owns = map mean (transpose [drop 3 y | Own y _ <- owns])
    mean values = sum values / fromIntegral (length values)
    near motion =
      let (x, y) = movePoint (Frame.inverse begin) (movePoint motion centre)
          centre = movePoint (Frame.inverse motion) pivot
          turn = abs (motionRotation motion - motionRotation begin)
       in abs (x - fst centre) < 3 && abs (y - snd centre) < 3 && min turn (abs (360 - turn)) < 15

-- | The fewest pixels that are aligned.
leastPixels :: Int
leastPixels = 100

-- | The initial standard deviation of a frame's rotation, in radians, where it is to be estimated
-- (assumption).
rotationPrior :: Double
rotationPrior = toRadians 1

-- | The root mean square of the rotations that are to be estimated, given their variances.
rotationAmong :: [Touch] -> [Own] -> [Double] -> Double
rotationAmong touches owns variances
  | null squares = rotationPrior
  | otherwise = sqrt (sum squares / fromIntegral (length squares))
  where
    squares =
      [ rotation * rotation + variance
        | (touch, Own (_ : _ : rotation : _) _, variance) <- zip3 touches owns variances,
          snd (touchErrors touch) == Nothing
      ]

-- | The normal equations of one frame, and sums for its new noise variance. The rows and the
-- gradient have the motion's parameters first, then the frame's own. 'normalLeft' is the sum of
-- a_i^2 d_i^2, 'normalLevers' that of a_i^2 b_i b_i^T divided by the old variance, 'normalSlopes'
-- that of a_i^2, and 'normalPrior' is the old variance.
data Normal = Normal
  { normalRows :: !Matrix,
    normalGradient :: ![Double],
    normalLeft :: !Double,
    normalLevers :: !Matrix,
    normalSlopes :: !Double,
    normalPrior :: !Double
  }

-- | A pixel: its place relative to the pivot, its rotated place relative to the frame's centre, its
-- reading, and the relief's height and slopes there along the grid's axes.
data PosePixel = PosePixel
  { pixelX, pixelY, pixelU, pixelW, pixelReading, pixelHeight, pixelAcross, pixelDown :: !Double
  }

-- | The pixels of a frame that lie on the ground. The arguments are the ground; the pivot; the
-- motion from the face's frame to the grid; the frame; and its own parameters.
pixelsOn :: Ground -> (Double, Double) -> Motion -> Touch -> Own -> [PosePixel]
pixelsOn ground (cx, cy) motion touch (Own own _) =
  [ PosePixel (x - cx) (y - cy) u w value h (c * a - s * b) (s * a + c * b)
    | (i, j, value) <- U.toList (touchPixels touch),
      let (u, w) = around (i, j)
          (x, y) = (mx + ex + u, my + ey + w)
          (x', y') = onFace (x, y),
      Just (h, a, b) <- [heightAt ground (x' + backX, y' + backY)]
  ]
  where
    (ex, ey, turn) = case own of
      a : b : angle : _ -> (a, b, angle)
      _ -> (0, 0, 0)
    (mx, my) = touchMiddle touch
    Motion turnBack backX backY = Frame.inverse motion
    (c, s) = cosineSine (motionRotation motion)
    around = rotated (toDegrees turn)
    -- Not 'movePoint', which would compute the sine and the cosine for each pixel.
    onFace = rotated turnBack

-- | The normal prior of a frame's own parameters: their expected values and the inverses of their
-- variances.
data OwnPrior = OwnPrior ![Double] ![Double]

-- | The arguments are the standard deviation of an unknown rotation, radians; the greatest reading;
-- the expected offset and gain; and the frame.
ownPrior :: Double -> Double -> [Double] -> Touch -> OwnPrior
ownPrior r strongest common touch =
  OwnPrior ([0, 0, 0] ++ common) $
    map
      (\sd -> 1 / (sd * sd))
      [max 0.01 sigma, max 0.01 sigma, max 1e-4 (maybe r toRadians turned), level, level]
  where
    (sigma, turned) = touchErrors touch
    level = 0.2 * strongest

-- | The normal equations of a frame at the present values of its own parameters, given its pixels.
normalOf :: OwnPrior -> Own -> [PosePixel] -> Normal
normalOf (OwnPrior expected informations) (Own own v) pixels =
  Normal
    { normalRows =
        zipWith (\i -> zipWith (\j x -> x / v + prior i j) [0 ..]) [0 ..] (gram columns),
      normalGradient = zipWith (\a pull -> product' a rests / v + pull) columns pulls,
      normalLeft = U.sum (U.zipWith (\w d -> w * d * d) slopes' rests),
      normalLevers =
        scaled (1 / v) (gram (map (U.zipWith (\w a -> sqrt w * a) slopes') (drop 3 columns))),
      normalSlopes = U.sum slopes',
      normalPrior = v
    }
  where
    (offset, gain) = case drop 3 own of
      [low, factor] -> (low, factor)
      _ -> (0, 0)
    column :: (PosePixel -> Double) -> U.Vector Double
    column part = U.fromList (map part pixels)
    across = column (\p -> gain * pixelAcross p)
    down = column (\p -> gain * pixelDown p)
    heights = column pixelHeight
    columns =
      [ U.map negate across,
        U.map negate down,
        column (\p -> gain * (pixelAcross p * pixelY p - pixelDown p * pixelX p)),
        across,
        down,
        column (\p -> gain * (pixelDown p * pixelU p - pixelAcross p * pixelW p)),
        U.map (const 1) heights,
        heights
      ]
    readings = column pixelReading
    rests = U.zipWith (\value h -> value - offset - gain * h) readings heights
    slopes' = U.zipWith (\a b -> a * a + b * b) across down
    -- The motion has no prior.
    prior i j = if i == (j :: Int) then (ofMotion ++ informations) !! i else 0
    pulls = ofMotion ++ zipWith3 (\w e now -> w * (e - now)) informations expected own
    ofMotion = [0, 0, 0]

-- | The inner product of two columns.
product' :: U.Vector Double -> U.Vector Double -> Double
product' !a !b = go 0 0
  where
    !n = min (U.length a) (U.length b)
    go !i !total
      | i >= n = total
      | otherwise = go (i + 1) (total + U.unsafeIndex a i * U.unsafeIndex b i)

-- | The inner products of all pairs of columns, a symmetric matrix.
gram :: [U.Vector Double] -> Matrix
gram columns = rows
  where
    rows =
      [ [ if j < i then rows !! j !! i else product' a b
          | (j, b) <- zip [0 ..] columns
        ]
        | (i, a) <- zip [0 :: Int ..] columns
      ]

-- | The normal equations of the motion after a frame's own parameters are eliminated.
data Reduced = Reduced
  { reducedRows :: !Matrix,
    reducedGradient :: ![Double],
    -- | Y^-1, Y^-1 Z^T and Y^-1 l
    reducedOwn :: !(Matrix, Matrix, [Double]),
    -- | the new noise variance v
    reducedLeft :: !Double
  }

-- | Eliminates a frame's own parameters. The number is a lower bound on its noise variance.
eliminated :: Double -> Normal -> Maybe Reduced
eliminated least normal = do
  own <- inverse y
  let back = own `times` transpose z
      levers = sum (concat (zipWith (zipWith (*)) own (normalLevers normal)))
      free = normalSlopes normal - levers
  pure
    Reduced
      { reducedRows = x `plus` scaled (-1) (z `times` back),
        reducedGradient = zipWith (-) k (transpose back `applied` l),
        reducedOwn = (own, back, own `applied` l),
        reducedLeft =
          -- If few pixels remain after the fit, they fit whatever their errors are.
          if free > normalSlopes normal / 10
            then max least (normalLeft normal / free)
            else normalPrior normal
      }
  where
    x = map (take 3) (take 3 (normalRows normal))
    z = map (drop 3) (take 3 (normalRows normal))
    y = map (drop 3) (drop 3 (normalRows normal))
    (k, l) = splitAt 3 (normalGradient normal)

-- | The dispersion of the frames' scores, at least 1.
dispersion :: Matrix -> [Reduced] -> Double
dispersion covariance solved
  | frames < 2 = 1
  | otherwise = max 1 (frames / (frames - 1) * sum (map square solved) / 3)
  where
    frames = fromIntegral (length solved)
    square one =
      let score = reducedGradient one in sum (zipWith (*) score (covariance `applied` score))

-- | A frame's own parameters after a step dx of the motion.
updated :: [Double] -> Reduced -> Own -> Own
updated dx reduced (Own own _) =
  Own (zipWith3 (\o l m -> o + l - m) own ownStep (back `applied` dx)) (reducedLeft reduced)
  where
    (_, back, ownStep) = reducedOwn reduced

-- | The variance of a frame's rotation, given the covariance of the motion.
rotationVariance :: Matrix -> Reduced -> Double
rotationVariance covariance reduced = (own `plus` propagated back covariance) !! 2 !! 2
  where
    (own, back, _) = reducedOwn reduced
