-- | Every decoder against the definition, on every combination: symbols or probabilities, one patch
-- or several, in any symmetries, on every surface; the decoders for large arrays on small ones.
module Test.Code.Locate.EveryDecoderAsDefined (spec, smallArrays) where

import Control.Monad (forM_)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Locate
import PraTactile.Locate.Decision
import PraTactile.Locate.Decoder.Algebra
import PraTactile.Locate.Decoder.Codebook
import PraTactile.Locate.Decoder.Nearest
import PraTactile.Locate.Definition
import PraTactile.Locate.Patch (patchOf)
import PraTactile.Symmetry
import PraTactile.Window
import Test.Code.Generators
import Test.Code.Locate.Asking
import Test.Code.Locate.Laws
import Test.Code.Locate.Scenes
import Test.Effort
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  it "all decoders agree on every content of a window of small arrays" $
    forM_ (byEffort (filter quicklyCompared) id smallArrays) $ \(q, n, shape, window) ->
      forM_
        [ (folding, surface)
          | folding <- [minBound ..],
            folding == RowMajor || gcd (rows shape) (columns shape) == 1,
            surface <- [naturalSurface folding, Sheet]
        ]
        $ \(folding, surface) -> onArray (q, n, folding, shape, window) (everyContent surface)
  forM_ settings $ \setting -> describe (settingName setting) $ do
    forM_ (Nothing : map Just symbolDecoders) $ \decoder ->
      it ("symbols: " ++ decoderName decoder) $
        withMaxSuccess (byEffort 30 120) $
          ofArray setting $ \array m ->
            forAll (genScene array genSymbol) $ \patches ->
              forAll (genQuestion array decoder) $ \(surface, possible, radius) ->
                asDefined decoder (surface, array, m) possible radius patches
    it "symbols: decoders that correct the same errors give the same answers" $
      withMaxSuccess (byEffort 40 150) $
        ofArray setting $ \array m ->
          forAll (genScene array genSymbol) $ \patches ->
            forAll (genQuestion array (Just InformationSetDecoder)) $
              \(surface, possible, radius) ->
                alike (surface, array, m) possible radius patches
    forM_ [NearestDecoder, InformationSetDecoder] $ \decoder ->
      it ("symbols: errors up to the guaranteed radius are corrected: " ++ decoderText decoder) $
        withMaxSuccess (byEffort 40 150) $
          ofArray setting $ \array m ->
            forAll (genWithin array) $ \(surface, possible, truth, wrong, cells) ->
              asPromised decoder (surface, array, m) possible truth wrong cells
    forM_ [Nothing, Just PosteriorDecoder, Just ListDecoder] $ \decoder ->
      forM_ [("probabilities", False), ("probabilities that show the orientation", True)] $
        \(name, shows') ->
          it (name ++ ": " ++ decoderName decoder) $
            withMaxSuccess (byEffort 18 80) $
              ofArray setting $ \array m ->
                forAll (genScene array (genLook shows')) $ \patches ->
                  forAll (genQuestion array decoder) $ \(surface, possible, _) ->
                    forAll (QuickCheck.elements [0, 0.001, 0.1]) $ \tolerated ->
                      asBayes decoder (surface, array, m) possible tolerated patches
    forM_ [PosteriorDecoder, ListDecoder] $ \decoder ->
      it ("certain probabilities are answered as symbols: " ++ decoderText decoder) $
        withMaxSuccess (byEffort 30 100) $
          ofArray setting $ \array m ->
            forAll (genScene array genSymbol) $ \patches ->
              forAll (genQuestion array (Just ListDecoder)) $ \(surface, possible, _) ->
                -- On the sheet a list knows less of the doubt.
                let known
                      | decoder == ListDecoder = naturalSurface (arrayFolding array)
                      | otherwise = surface
                 in asSymbols decoder (known, array, m) possible patches
  describe "on a sheet of 63 x 65 cells, a few cells of a patch of the sheet's size" $
    -- One cell leaves 2048 positions of the torus, more than are listed.
    forM_
      [ (NearestDecoder, [identity], byEffort 40 150),
        (NearestDecoder, rotations, byEffort 20 60),
        (InformationSetDecoder, [identity], byEffort 45 300),
        (AlgebraDecoder, [identity], byEffort 45 300)
      ]
      $ \(decoder, possible, count) ->
        it (decoderText decoder ++ ", symmetries: " ++ show (length possible)) $
          withMaxSuccess count $
            ofArray (2, 12, Diagonal, Shape 63 65, Shape 6 2) $ \array m ->
              forAll (genRadius (Just decoder)) $ \radius ->
                forAll (genWide array) $
                  asDefined (Just decoder) (Sheet, array, m) possible radius . alone
  where
    settingName (q, n, folding, shape, _) =
      "over GF(" ++ show q ++ "), n = " ++ show n ++ ", " ++ show folding ++ ", " ++ show shape
    decoderName = maybe "the decoder that is chosen" decoderText

symbolDecoders :: [DecoderName]
symbolDecoders =
  [TableDecoder, AlgebraDecoder, SearchDecoder, NearestDecoder, InformationSetDecoder]

settings :: [Setting]
settings =
  [ (4, 4, Diagonal, Shape 15 17, Shape 2 2),
    (2, 6, Diagonal, Shape 7 9, Shape 3 2),
    (2, 6, RowMajor, Shape 9 7, Shape 2 3),
    (3, 3, Diagonal, Shape 2 13, Shape 1 3),
    (5, 3, Diagonal, Shape 4 31, Shape 1 3),
    (9, 2, Diagonal, Shape 5 16, Shape 1 2),
    (16, 2, Diagonal, Shape 15 17, Shape 1 2),
    (17, 2, RowMajor, Shape 9 32, Shape 1 2)
  ]

-- | The field's order, the degree, a shape of q^n - 1 cells, and a window: with the window
-- property, with windows that repeat, and with more cells than are needed.
smallArrays :: [(Int, Natural, Shape, Shape)]
smallArrays =
  [ (2, 4, Shape 3 5, Shape 2 2),
    (2, 6, Shape 7 9, Shape 3 2),
    (2, 6, Shape 7 9, Shape 2 2),
    (2, 4, Shape 3 5, Shape 3 3),
    (3, 3, Shape 2 13, Shape 1 3),
    (3, 3, Shape 2 13, Shape 2 3),
    (4, 2, Shape 3 5, Shape 2 2),
    (4, 4, Shape 15 17, Shape 2 2),
    (4, 4, Shape 15 17, Shape 1 3),
    (5, 3, Shape 4 31, Shape 1 3),
    (9, 2, Shape 8 10, Shape 1 2),
    (9, 2, Shape 5 16, Shape 1 2),
    (16, 1, Shape 3 5, Shape 1 2)
  ]

-- | Whether its cells and the contents of its window are so few that to compare them all is quick.
quicklyCompared :: (Int, Natural, Shape, Shape) -> Bool
quicklyCompared (q, n, _, window) = fromIntegral q ^ (n + area window) <= (10000 :: Natural)

-- | The decoders that correct nothing, and the nearest position at distance 0, have one outcome for
-- each content of the window on this surface, and it has the positions where the content stands.
everyContent :: KnownField k => Surface -> PseudorandomArray k -> Mask -> Expectation
everyContent surface array m = do
  table <- right (buildTable MostSignificantFirst on m)
  codebook <- right (buildCodebook on m)
  algebra <- right (prepareAlgebra on m)
  let q = fieldOrder array
      standing =
        Map.fromListWith
          (flip (++))
          [ (map toCode content, [p])
            | p <- cellsOf (arrayShape array),
              Just content <- [windowAt on m p]
          ]
      oneOutcome codes content =
        searchPatch on m p == Right outcome
          && algebraPatch algebra p == Right outcome
          && decisionOutcome (nearest codebook (UpTo 0) p) == outcome
          && positions outcome == Map.findWithDefault [] codes standing
        where
          p = patchOf (maskExtent m) (sortOn fst (zip (maskOffsets m) content))
          outcome = locatePatch table p
      failing =
        [ codes
          | codes <- mapM (const [0 .. q - 1]) (maskOffsets m),
            Right content <- [traverse fromCode codes],
            not (oneOutcome codes content)
        ]
  failing `shouldBe` []
  where
    on = ArrayOn surface array
    positions outcome = case outcome of
      Unique place _ -> [place]
      Ambiguous several _ -> several
      _ -> []
