-- | Every decoder against the definition, on every combination: symbols or probabilities, one patch
-- or several, in any symmetries, on every surface; the decoders for large arrays on small ones.
module Test.Code.Locate.EveryDecoderAsDefined (spec) where

import Control.Monad (forM_)
import PraTactile.Array
import PraTactile.Locate
import PraTactile.Symmetry
import Test.Code.Generators
import Test.Code.Locate.Asking
import Test.Code.Locate.Laws
import Test.Code.Locate.Scenes
import Test.Hspec
import Test.QuickCheck hiding (elements)
import qualified Test.QuickCheck as QuickCheck

spec :: Spec
spec = do
  forM_ settings $ \setting -> describe (settingName setting) $ do
    forM_ (Nothing : map Just symbolDecoders) $ \decoder ->
      it ("symbols: " ++ decoderName decoder) $
        onArray setting $ \array m ->
          holds 120 $
            forAll (genScene array genSymbol) $ \patches ->
              forAll (genQuestion array decoder) $ \(surface, possible, radius) ->
                asDefined decoder (surface, array, m) possible radius patches
    it "symbols: decoders that correct alike answer alike" $
      onArray setting $ \array m ->
        holds 150 $
          forAll (genScene array genSymbol) $ \patches ->
            forAll (genQuestion array (Just InformationSetDecoder)) $
              \(surface, possible, radius) ->
                alike (surface, array, m) possible radius patches
    forM_ [NearestDecoder, InformationSetDecoder] $ \decoder ->
      it ("symbols: as many wrong cells as are promised are corrected: " ++ decoderText decoder) $
        onArray setting $ \array m ->
          holds 150 $
            forAll (genWithin array) $ \(surface, possible, truth, wrong, cells) ->
              asPromised decoder (surface, array, m) possible truth wrong cells
    forM_ [Nothing, Just PosteriorDecoder, Just ListDecoder] $ \decoder ->
      forM_ [("probabilities", False), ("probabilities that show how it lies", True)] $
        \(name, shows') ->
          it (name ++ ": " ++ decoderName decoder) $
            onArray setting $ \array m ->
              holds 80 $
                forAll (genScene array (genLook shows')) $ \patches ->
                  forAll (genQuestion array decoder) $ \(surface, possible, _) ->
                    forAll (QuickCheck.elements [0, 0.001, 0.1]) $ \tolerated ->
                      asBayes decoder (surface, array, m) possible tolerated patches
    forM_ [PosteriorDecoder, ListDecoder] $ \decoder ->
      it ("probabilities that leave no doubt are symbols: " ++ decoderText decoder) $
        onArray setting $ \array m ->
          holds 100 $
            forAll (genScene array genSymbol) $ \patches ->
              forAll (genQuestion array (Just ListDecoder)) $ \(surface, possible, _) ->
                -- On the sheet a list knows less of the doubt.
                let known
                      | decoder == ListDecoder = naturalSurface (arrayFolding array)
                      | otherwise = surface
                 in asSymbols decoder (known, array, m) possible patches
  describe "on a sheet of 63 x 65 cells, a few cells in a patch as large as it" $
    -- One cell leaves 2048 positions of the torus, more than are listed.
    forM_
      [ (NearestDecoder, [identity], 150),
        (NearestDecoder, rotations, 60),
        (InformationSetDecoder, [identity], 300),
        (AlgebraDecoder, [identity], 300)
      ]
      $ \(decoder, possible, count) ->
        it (decoderText decoder ++ ", symmetries: " ++ show (length possible)) $
          onArray (2, 12, Diagonal, Shape 63 65, Shape 6 2) $ \array m ->
            holds count $
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
