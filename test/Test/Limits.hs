-- | What is refused beyond which size: the numbers that are stated, in figures. They are promises,
-- for what was accepted once must be accepted later.
module Test.Limits (spec) where

import Data.Maybe (isJust)
import qualified PraTactile.Census as Census
import qualified PraTactile.Classification.Estimate as Estimate
import qualified PraTactile.Classification.Regimen as Regimen
import qualified PraTactile.Conformance.Question.Touch as Touch
import qualified PraTactile.DiscreteLog as DiscreteLog
import qualified PraTactile.Factorisation as Factorisation
import qualified PraTactile.Files as Files
import qualified PraTactile.Grid as Grid
import qualified PraTactile.Image.Pgm as Pgm
import qualified PraTactile.LinearCode.Punctured as Punctured
import qualified PraTactile.Locate.Decoder.Algebra as Algebra
import qualified PraTactile.Locate.Decoder.List as List
import qualified PraTactile.Locate.Decoder.MemoryTable as MemoryTable
import qualified PraTactile.Locate.Definition as Definition
import qualified PraTactile.Locate.Joint as Joint
import qualified PraTactile.Locate.Separation as Separation
import qualified PraTactile.Rates.Formulas as Formulas
import qualified PraTactile.Rates.Setup as Setup
import qualified PraTactile.Registration as Stitch
import qualified PraTactile.Registration.Search as Search
import qualified PraTactile.Segmentation as Segment
import qualified PraTactile.Window.Distance as Distance
import qualified PraTactile.Window.Enumeration as Enumeration
import Test.Hspec

spec :: Spec
spec = do
  it "of windows and arrays" $
    [ Grid.largestGrid,
      Enumeration.largestSpan Enumeration.standardLimits,
      Enumeration.largestSort Enumeration.standardLimits,
      Enumeration.largestMap Enumeration.standardLimits,
      Enumeration.largestReading Enumeration.standardLimits,
      Distance.largestSearch,
      Census.largestShapes
    ]
      `shouldBe` [268435456, 1073741824, 67108864, 1048576, 67108864, 16777216, 65536]
  it "of integers" $ do
    [DiscreteLog.mostBabySteps, DiscreteLog.largestFeasiblePrime]
      `shouldBe` [262144, 1099511627776]
    length (show Factorisation.largestPower) `shouldBe` 309
    [Factorisation.largestPower `mod` m | m <- [7, 11, 13]] `shouldBe` [2, 5, 3]
  it "of training: the seed of the shipped network, which 'train' takes if none is given" $
    Regimen.shippedSeed `shouldBe` 2004
  it "of decoders" $ do
    [MemoryTable.largestTable, Definition.largestSearchedArray, Separation.largestOrientedSearch]
      `shouldBe` [67108864, 1048576, 262144]
    Joint.mostPatches `shouldBe` 100
    Algebra.largestListing `shouldBe` 1024
    List.standardListing `shouldBe` 65536
  it "of rates" $ do
    Punctured.mostErasedCells `shouldBe` 25
    Punctured.mostErasedWork `shouldBe` 8589934592
    map (isJust . uncurry Punctured.punctured) [(25, ones 256), (25, ones 257), (26, ones 1)]
      `shouldBe` [True, False, False]
    Formulas.mostCells `shouldBe` 1000
    Setup.largestSetup `shouldBe` 33554432
  it "of images, composites and files" $ do
    [Pgm.maxPixels, Stitch.maxImagePixels, Stitch.maxCompositePixels]
      `shouldBe` [16777216, 1048576, 4194304]
    [Stitch.maxFrames, Stitch.maxFramePixels] `shouldBe` [10000, 8388608]
    [Stitch.maxComparisons, Stitch.maxPairPixels, Stitch.maxLatticePixels]
      `shouldBe` [536870912, 4294967296, 65536]
    Files.largestInput `shouldBe` 268435456
    map (Search.usable . uncurry searching) [(1, 64), (16, 4), (1, 64.001), (16, 4.001)]
      `shouldBe` [True, True, False, False]
    Touch.fullScale `shouldBe` 65535
    Segment.leastSeen `shouldBe` 6
    Estimate.leastDoubt `shouldBe` 1e-7
  where
    -- Words of which one cell is not 0.
    ones count = replicate count 1
    -- Displacements of that standard deviation, in taxels, and a search of so many of them.
    searching sigma reach =
      Search.standardRegistration
        { Search.registrationSigma = Just sigma,
          Search.registrationReach = reach
        }
