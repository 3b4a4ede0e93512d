-- | What composites show if their frames do not lie where the robot has them, and what that takes
-- from an answer: hypotheses beside the one that was put together, each with its probability
-- beforehand, its likelihood by overlaps and lattice, and by what the array makes of it.
module PraTactile.Recognise.Elsewhere
  ( Elsewhere (..),
    putOtherwise,
    doubtsElsewhere,
  )
where

import Data.List (find, inits, tails)
import Data.Maybe (fromMaybe)
import PraTactile.Geometry (taxelPitch)
import PraTactile.Image (rasterSize)
import PraTactile.Locate (doubtOfForeign)
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.Recognition
import PraTactile.Registration (Composite (..), Fault (..), Otherwise (..))
import PraTactile.Registration.Layout (cellsAround, faultAt)

-- | Composites put together otherwise.
data Elsewhere = Elsewhere
  { elsewhereFault :: !Fault,
    -- | The probability of 'OneFrame'; the odds of any other fault against what was put together,
    -- before the array is asked.
    elsewhereOdds :: !Double,
    elsewhereComposites :: [Composite]
  }

-- | How probable faults of a kind are together beforehand, where axes were stated or not.
faultPrior :: Tolerance -> Bool -> Fault -> Double
faultPrior tolerance stated fault = case fault of
  OneFrame -> 1
  OtherAxes _ -> fromMaybe (if stated then 0.0025 else 0.01) (axesPrior tolerance)
  OtherScale _ _ -> 0.004
  Slip -> slipPrior tolerance

-- | The composites of one face put together otherwise, given by how many degrees the symbols are
-- turned in them: one of them with one frame elsewhere or with a slip in it; one of them but the
-- first a whole cell away from where the robot has it; or all of them along other axes, or at
-- another scale.
putOtherwise :: Tolerance -> Double -> [Composite] -> [Elsewhere]
putOtherwise tolerance angle composites =
  [ elsewhereBy other (before ++ otherwiseComposite other : after)
    | (before, composite, after) <- each,
      other <- compositeOthers composite,
      ofOne other
  ]
    ++ [ Elsewhere Slip (slipPrior tolerance / 4) (before ++ moved cell composite : after)
         | (before@(_ : _), composite, after) <- each,
           cell <- cellsAround angle
       ]
    ++ [ elsewhereBy other {otherwiseLikelier = product likelier} there
         | other <- ofAll,
           Just (likelier, there) <- [unzip <$> traverse (under (otherwiseFault other)) composites]
       ]
  where
    each =
      [ (before, one, after)
        | (before, one : after) <- zip (inits composites) (tails composites)
      ]
    elsewhereBy (Otherwise fault share likelier _) =
      Elsewhere fault (faultPrior tolerance stated fault * share * likelier)
    stated = any compositeAxesStated composites
    ofOne other = otherwiseFault other `elem` [OneFrame, Slip]
    -- As the first composite of several frames has them: one image alone would show the same.
    ofAll =
      concat . take 1 . filter (not . null) $
        map (filter (not . ofOne) . compositeOthers) composites
    moved (i, j) composite =
      let (x, y) = compositeOrigin composite
       in composite {compositeOrigin = (x + taxelPitch * i, y + taxelPitch * j)}
    under fault composite
      | length (compositeDisplacements composite) < 2 = Just (1, displaced fault composite)
      | otherwise =
        (\other -> (otherwiseLikelier other, otherwiseComposite other))
          <$> find ((== fault) . otherwiseFault) (compositeOthers composite)

-- | One image, whose centre lies elsewhere by a fault.
displaced :: Fault -> Composite -> Composite
displaced fault composite = composite {compositeOrigin = (x' - halfWidth, y' - halfHeight)}
  where
    (left, top) = compositeOrigin composite
    (w, h) = rasterSize (compositeImage composite)
    (halfWidth, halfHeight) = (half w, half h)
    half side = taxelPitch * fromIntegral (side - 1) / 2
    (x', y') = faultAt fault (left + halfWidth, top + halfHeight)

-- | What hypotheses with what they show leave of an answer: how probable it is that one frame lies
-- elsewhere, that axes or scale are others, and that frames slipped, and they show something else.
doubtsElsewhere :: Recognition -> [(Elsewhere, Maybe Recognition)] -> (Double, Double, Double)
doubtsElsewhere shown others = (sum (map snd (of' oneFrame)), share axes, share slip)
  where
    weighed =
      [ (fault, odds other recognition, maybe True (differs fault shown) recognition)
        | (other, recognition) <- others,
          let fault = elsewhereFault other
      ]
    odds other recognition
      | oneFrame (elsewhereFault other) = elsewhereOdds other
      | otherwise = elsewhereOdds other * maybe 1 likelierByArray recognition
    of' kind = [(fault, o) | (fault, o, True) <- weighed, kind fault]
    share kind = sum (map snd (of' kind)) / total
    -- That what was put together is right has odds of 1.
    total = 1 + sum [o | (fault, o, _) <- weighed, not (oneFrame fault)]
    likelierByArray recognition =
      let l = byArray recognition - byArray shown
       in exp (signum l * max 0 (min 30 (abs l) - unsure))
    -- A certain symbol more, which the one shows and the other does not, is no evidence.
    unsure = 2
    oneFrame = (== OneFrame)
    axes fault = case fault of
      OtherAxes _ -> True
      OtherScale _ _ -> True
      _ -> False
    slip = (== Slip)

-- | How much likelier, as a natural logarithm, what was recognised is as the array's than as
-- anything else's, but for what is the same for all hypotheses.
byArray :: Recognition -> Double
byArray recognition = case recognisedSupport recognition of
  Nothing -> 0
  Just support ->
    let foreign' = doubtOfForeign (doubtsOfOrigin (supportDoubts support))
     in log (max 1e-13 (1 - foreign')) - log (max 1e-300 foreign')
