{-# LANGUAGE OverloadedStrings #-}

-- | Tests what a store answers and refuses, in any database.
module Test.Store.Answers (spec) where

import Data.Bifunctor (first)
import Data.Foldable (for_)
import Data.Text (Text)
import qualified Data.Text as Text
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Canonical
import PraTactile.Object.Placement hiding (blockCells)
import PraTactile.Object.WingedEdge
import PraTactile.Store
import Test.Effort
import Test.Hspec
import Test.QuickCheck (choose, shuffle, vectorOf)
import Test.Recognition.Object.Support
import Test.Store.Asking
import Test.Store.Damage
import Test.Store.Homes

spec :: SpecWith Home
spec = do
  describe "answers as the placement" $ do
    it "for windows of 2 x 2, and of other shapes" $
      withCanonical $ \place _ path ->
        asked path $ \store -> do
          -- On faces, across them, and on no object.
          let everyFifth = [at | (i, at) <- zip [0 :: Int ..] somePositions, i `mod` 5 == 0]
              fewer = byEffort everyFifth somePositions
          for_
            ( (Shape 2 2, somePositions) :
              map
                (flip (,) fewer)
                [Shape 1 1, Shape 3 4, Shape 0 2, Shape 4 5, Shape 1 17, Shape 16 18]
            )
            $ \(window, positions) ->
              for_ positions $ \at ->
                storedWhereabouts store window at `shouldReturn` Right (whereabouts place window at)
    it "for positions and windows of any size, as on the torus" $
      withCanonical $ \place _ path ->
        asked path $ \store -> do
          let huge = 10 ^ (30 :: Int)
          let far = Position (15 * huge + 6) (17 * huge + 5)
          for_ [(canonicalWindow, far), (Shape huge huge, Position 3 4)] $ \(window, at) ->
            storedWhereabouts store window at `shouldReturn` Right (whereabouts place window at)
    it "for the cells of every face, and for cells that do not exist" $
      withCanonical $ \place _ path ->
        asked path $ \store ->
          for_ blocks $ \block -> do
            let beyond =
                  [ Position (blockRows block) 0,
                    Position 0 (blockColumns block),
                    Position 0 (10 ^ (30 :: Int))
                  ]
            -- A quick run takes the first and the last cell of a face.
            let within = map snd (blockCells block)
                cells = byEffort (take 1 within ++ take 1 (reverse within)) within
            for_ (cells ++ beyond) $ \cell ->
              storedPosition store (blockFace block) cell
                `shouldReturn` first NotInStore (arrayPosition place (blockFace block) cell)
    it "for faces that it finds, and for those that it refuses" $
      withCanonical $ \place _ path ->
        asked path $ \store ->
          for_
            [ ("cube", "C3 C4 C1 C2"),
              ("cube", "C4 C3 C2 C1"),
              ("cube", "P1 P2 P3 P4"),
              ("cube", ""),
              ("sphere", "C1 C2")
            ]
            $ \(object, face) -> do
              let named = Face object (readFaceName face)
                  cell = Position 1 1
              storedPosition store named cell
                `shouldReturn` first NotInStore (arrayPosition place named cell)
    it "for a face that is not laid" $
      \home -> theCube $ \solid_ ->
        right
          (placement (Shape 15 17) canonicalPitch [solid_] (take 1 canonicalLayings))
          >>= \place -> do
            path <- newName home
            let top = Face "cube" (readFaceName "C1 C2 C3 C4")
            create path "profile" place `shouldReturn` Right ()
            asked path $ \store -> do
              storedPosition store top (Position 0 0)
                `shouldReturn` Left (NotInStore (FaceNotLaid top))
              for_ everyPosition $ \at ->
                storedWhereabouts store canonicalWindow at
                  `shouldReturn` Right (whereabouts place canonicalWindow at)
    it "the placement and the profile are read back" $
      withCanonical $ \place _ path ->
        asked path $ \store -> do
          storedPlacement store `shouldReturn` Right place
          storedProfile store `shouldBe` profileText
    it "the seal of every row is the one that another program computes" $ \home ->
      thePlacement $ \place -> do
        path <- newName home
        create path "a \"quoted\" profile, \955" place `shouldReturn` Right ()
        sealsFound home path >>= \found -> case found of
          Nothing -> pendingWith "python3 is not installed here, so it found no seals"
          Just (rows_, same) -> (rows_, same) `shouldSatisfy` (\(n, m) -> n == m && n > 100)
    it "numbers are stored up to 64 bits; a larger one leaves the file as it was" $
      withCanonical $ \place _ path -> do
        let stored high = do
              tall <- either (fail . show) pure (placement (Shape high 17) canonicalPitch [] [])
              made <- create path profileText tall
              pure (either Just (const Nothing) made)
            most = 2 ^ (63 :: Int) - 1
        mapM stored [most + 1, 10 * most]
          `shouldReturn` [Just (TooLarge (toInteger n)) | n <- [most + 1, 10 * most]]
        asked path $ \store -> storedPlacement store `shouldReturn` Right place
        mapM stored [15, most] `shouldReturn` [Nothing, Nothing]
        asked path $ \store -> do
          storedWhereabouts store canonicalWindow (Position (most - 1) 3)
            `shouldReturn` Right OnNoObject
          storedPosition store (blockFace (blocks !! 0)) (Position 0 0)
            `shouldReturn` Left (NotInStore (UnknownObject "cube"))
  describe "refuses, with a reason and no exception," $ do
    for_ [1, 2, 4] $ \version ->
      it ("tables of version " ++ show version) $
        tampered (Text.pack ("UPDATE metadata SET schema_version = " ++ show version)) $
          \_ outcome ->
            outcome `shouldBe` Left (WrongSchemaVersion version 3)
    it "a store of another profile" $
      withCanonical $ \_ _ path ->
        withStore path (Just "another") (const (pure ()))
          `shouldReturn` Left (ForeignProfile profileText "another")
    it "a table that is missing" $
      tampered "DROP TABLE edge" $ \path outcome -> outcome `shouldBe` Left (TablesDiffer path)
    it "a table with a further column" $
      tampered "ALTER TABLE edge ADD COLUMN length_um INTEGER NOT NULL DEFAULT 7" $ \path outcome ->
        outcome `shouldBe` Left (TablesDiffer path)
    it "a table without one of its columns" $
      tampered "ALTER TABLE edge RENAME COLUMN left_face TO left_side" $ \path outcome ->
        outcome `shouldBe` Left (TablesDiffer path)
  describe "gives the former answer or refuses, and fails the check, after" $ do
    it "any cell of any table was changed in number, word or type" $ \home ->
      ofDrawn 1 (vectorOf 20 (choose (0, 10000))) $ \picked ->
        flip withCanonical home $ \place _ path -> do
          changes <- concat <$> traverse (changesOf home path) tableNames
          length changes `shouldSatisfy` (> 100)
          let some = [changes !! (i `mod` length changes) | i <- picked]
          for_ (byEffort (take (cases home 12) some) changes) (toldOf place home path)
    it "any row of any table was deleted" $
      withCanonical $ \place home path -> do
        -- On a server each copy takes long, so a quick run takes every fourth table there.
        let apart = byEffort (length tableNames `div` max 1 (cases home (length tableNames))) 1
        for_ [table | (i, table) <- zip [0 ..] tableNames, i `mod` apart == 0] $ \table -> do
          some <- someRows home path table
          for_ (take (byEffort (max 1 (cases home 3)) 3) some) $ \at ->
            toldOf place home path (Text.unwords ["DELETE FROM", table, "WHERE", at])
    it "the first laid face was deleted, where each object has only one" $ \home ->
      thePlacement $ \place -> do
        let bodies = placementSolids place
            firstOf body =
              take 1 [it_ | it_ <- laidFaces place, faceObject (laidFace it_) == solidName body]
            layings = map layingOf (concatMap firstOf bodies)
        path <- newName home
        few <-
          either (fail . show) pure $
            placement (placementShape place) (placementPitch place) bodies layings
        create path profileText few `shouldReturn` Right ()
        execute home path ["DELETE FROM laying WHERE number = 1"]
        found <- withStore path Nothing (\store -> storedFirst store 1 (Shape 0 0))
        for_ (found >>= id) $ \some ->
          take 1 (laidFaces some) `shouldBe` take 1 (laidFaces few)
    it "rows were changed to contradict the others and sealed again" $ \home ->
      ofDrawn 1 (shuffle contradictions) $ \drawn -> flip withCanonical home $ \_ _ path ->
        for_ (byEffort (take (max 2 (cases home 3)) drawn) drawn) $ \(statements, expected) -> do
          changed <- copied home path
          execute home changed statements
          sealAgain home changed
          (,) statements <$> checking changed `shouldReturn` (statements, Left expected)

  describe "has keys that refuse" $
    for_ duplicates $ \(table, columns_) ->
      it ("a second row of " ++ Text.unpack table ++ " with the same key") $
        withCanonical $ \_ home path -> do
          let listed = Text.intercalate ", " columns_
              doubling =
                ["INSERT INTO", table, "(", listed, ") SELECT", listed, "FROM", table, "LIMIT 1"]
          executed home path [Text.unwords doubling] `shouldReturn` Left ByConstraint

-- Where the database accepts a change, the check refuses, and every look-up refuses or answers as
-- before.
toldOf :: Placement -> Home -> String -> Text -> Expectation
toldOf place home path change_ = do
  changed <- copied home path
  applied <- executed home changed [change_]
  case applied of
    -- A key or a column refused the change.
    Left why -> (change_, why) `shouldSatisfy` (`elem` [ByConstraint, ByType]) . snd
    Right () -> do
      check <- checking changed
      (change_, check) `shouldSatisfy` (/= Right ()) . snd
      either plain (const (pure ())) check
      opened <- withStore changed Nothing $ \store -> do
        for_ [(0, 0), (6, 5), (13, 5), (3, 9), (10, 11), (14, 16)] $ \(r, c) -> do
          let at = Position r c
          answer <- storedWhereabouts store canonicalWindow at
          for_ answer $ \it_ ->
            (change_, it_) `shouldBe` (change_, whereabouts place canonicalWindow at)
        for_ [blocks !! i | i <- [0, 11]] $ \block -> do
          answer <- storedPosition store (blockFace block) (Position 1 2)
          case answer of
            Left (NotInStore why) -> expectationFailure (show (change_, why))
            Left _ -> pure ()
            Right at ->
              Right at `shouldBe` arrayPosition place (blockFace block) (Position 1 2)
      either plain (const (pure ())) opened

-- One cell at a time, keys included, each with other values.
changesOf :: Home -> String -> Text -> IO [Text]
changesOf home path table = do
  columns_ <- otherValues home path table
  some <- someRows home path table
  pure
    [ Text.unwords ["UPDATE", table, "SET", column_, "=", to, "WHERE", at]
      | (column_, values) <- columns_,
        at <- some,
        to <- values
    ]

withCanonical :: (Placement -> Home -> String -> Expectation) -> Home -> Expectation
withCanonical test home = thePlacement $ \place -> do
  path <- newName home
  create path profileText place `shouldReturn` Right ()
  test place home path

tampered :: Text -> (String -> Either StoreError () -> Expectation) -> Home -> Expectation
tampered statement test =
  withCanonical $ \_ home path -> execute home path [statement] >> opening path >>= test path
