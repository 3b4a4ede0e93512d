-- | What was asked before does not matter, answered or refused: questions in an order that is
-- drawn, each with the answer that it has alone.
module PraTactile.Conformance.Laws.Order
  ( orderLaw,
    orderName,
  )
where

import Data.Aeson (object)
import PraTactile.Array (Shape (Shape), area)
import PraTactile.Conformance.Definition (Known, knownProfile)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Draw
import PraTactile.Conformance.Laws.Forms (typical)
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Laws.Smaller
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (listOf)
import PraTactile.Profile (Profile (..))
import Test.QuickCheck (choose, elements, oneof, vectorOf)

-- | That these operations, the last of which is of the stage, are answered alike in any order.
orderLaw :: Stage -> [Operation] -> Law Known
orderLaw stage operations =
  law
    stage
    orderName
    operations
    "an answer does not depend on what was asked before, nor on whether that was refused"
    "the protocol: each request is answered by itself"
    $ \known ->
      let one = oneof [elements (askedOf known operation) | operation <- operations]
       in Cases
            (listOf questionForm)
            (Some (choose (2, 5) >>= (`vectorOf` one)) (filter (not . null) . smallerList smaller))
            (inOrder known)

-- | The name of the law in each stage. An answer that is wrong in a fresh process, too, does not
-- violate it: that process was asked nothing before.
orderName :: String
orderName = "in-any-order"

-- | Questions of an operation, some of which are refused, each for another reason.
askedOf :: Known -> Operation -> [SomeQuestion]
askedOf known operation =
  SomeQuestion (Raw operation (object [])) : typical known operation ++ refusedOnes
  where
    refusedOnes = case operation of
      OfAdd -> [SomeQuestion (Add q 0)]
      OfInverse -> [SomeQuestion (Inverse 0)]
      OfPower -> [SomeQuestion (Power 0 (-1)), SomeQuestion (Power 0 0)]
      OfLogarithm -> [SomeQuestion (Logarithm 0)]
      OfPack -> [SomeQuestion (Pack [])]
      OfUnpack -> [SomeQuestion (Unpack (q ^ area (profileWindow p)))]
      OfProve -> map (SomeQuestion . Prove) ([] : beyond)
      OfDistance -> map (SomeQuestion . Distance) ([] : beyond)
      OfLocate -> SomeQuestion . Locate <$> patches
      OfNearest -> SomeQuestion . Nearest Nothing <$> patches
      OfPosterior -> SomeQuestion . Posterior . map (map (maybe Unfelt Certainly)) <$> patches
      _ -> []
    p = knownProfile known
    q = profileOrder p
    Shape n1 n2 = profileShape p
    -- No window of such a shape lies on the sheet.
    beyond = [replicate (fromIntegral n1 + 1) "#" | n1 < 128, n2 < 128]
    -- Nothing felt; zeros; and a window with every cell another one.
    patches =
      [[Nothing]] :
        [ map (map change) rows
          | place <- take 1 (places p (profileWindow p)),
            rows <- [seenAt known (profileWindow p) place],
            change <- [const (Just 0), Just . (`mod` q) . (+ 1)]
        ]
