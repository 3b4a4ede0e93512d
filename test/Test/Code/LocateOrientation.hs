{-# LANGUAGE DataKinds #-}

-- | What the code tells of turned and mirrored patches.
module Test.Code.LocateOrientation (spec) where

import Control.Monad (forM_)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Book
import PraTactile.Locate.Nearest
import PraTactile.Locate.Orientation
import PraTactile.Polynomial
import PraTactile.Window
import Test.Code.Generators
import Test.Hspec

spec :: Spec
spec = do
  it "an orientation and the one that undoes it lead back" $
    forM_ orientations $ \o -> seenAs (undone o) (seenAs o ["abc", "def"]) `shouldBe` ["abc", "def"]
  it "every rotation of a 2 x 2 window is again a window: the code alone tells no orientation" $ do
    shelf <- paperBook
    forM_ everywhere $ \p -> do
      seen <- look shelf 2 2 p
      map fst (nearestOriented shelf rotations Guaranteed seen) `shouldBe` rotations
  it "with unknown rotation the distance is 0 at 2x2 and 3x3, 4 at 4x4, 8 at 5x5, for the paper's polynomial" $ do
    shelf <- paperBook
    [orientedDistance shelf rotations side | side <- [2 .. 5]] `shouldBe` [0, 0, 4, 8]
  it "a 4 x 4 patch with one error is located in whatever rotation it is seen" $ do
    shelf <- paperBook
    forM_ [Position 0 0, Position 7 9, Position 14 16] $ \p -> forM_ rotations $ \o -> do
      cells <- lookRows shelf 4 4 p
      seen <- right (patch (seenAs o (oneWrong cells)))
      [(o', decisionOutcome d) | (o', d) <- nearestOriented shelf rotations (UpTo 1) seen] `shouldSatisfy` \found -> case found of
        [(o', Located place _)] -> (o', place) == (o, p)
        _ -> False
  it "an array whose windows have two columns is its own mirror image: a patch as wide as all of it, mirrored, stands somewhere" $ do
    polynomials <- right (primitivePolynomials 4)
    length polynomials `shouldBe` 32
    forM_ polynomials $ \h -> do
      array <- right (folded Diagonal (Shape 15 17) h)
      m <- right (rectangle (Shape 2 2))
      shelf <- right (book Torus array m)
      -- A patch as wide as the whole array, so that the mirror image of all of it is found.
      seen <- lookRows shelf 4 17 (Position 0 0)
      image <- right (patch (seenAs (Orientation True 0) seen))
      decisionNearest (nearest shelf (UpTo 0) image) `shouldBe` Just 0
 where
  everywhere = [Position r c | r <- [0 .. 14], c <- [0 .. 16]]
  oneWrong cells = case cells of
    (Just a : others) : rest -> (Just (a + 1) : others) : rest
    _ -> cells

look :: Book GF4 -> Natural -> Natural -> Position -> IO (Patch GF4)
look shelf h w p = lookRows shelf h w p >>= right . patch

lookRows :: Book GF4 -> Natural -> Natural -> Position -> IO [[Maybe (GF GF4)]]
lookRows shelf h w (Position r c) = pure [[Just (cellAt (bookArray shelf) (Position (r + i) (c + j))) | j <- takeWhile (< w) [0 ..]] | i <- takeWhile (< h) [0 ..]]

paperBook :: IO (Book GF4)
paperBook = do
  array <- right paperPrimitive >>= right . folded Diagonal (Shape 15 17)
  m <- right (rectangle (Shape 2 2))
  right (book Torus array m)
