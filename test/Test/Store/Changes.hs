{-# LANGUAGE OverloadedStrings #-}

-- | Tests changes of stores, and the cost of a look-up.
module Test.Store.Changes (spec, inFiles) where

import Control.Concurrent (forkIO)
import Control.Concurrent.MVar (isEmptyMVar, newEmptyMVar, putMVar, takeMVar)
import Control.Exception (bracket)
import Control.Monad (forM_, when, (>=>))
import Control.Monad.IO.Class (liftIO)
import Control.Monad.Logger (fromLogStr, runLoggingT)
import Control.Monad.Trans.Except (runExceptT)
import Control.Monad.Trans.Reader (ReaderT)
import Data.Bifunctor (first)
import qualified Data.ByteString.Char8 as Bytes
import Data.Foldable (for_)
import Data.IORef
import Data.List (isInfixOf, nub, sort)
import qualified Data.Map.Strict as Map
import qualified Data.Text as Text
import Data.Text.Encoding (decodeUtf8)
import Data.Traversable (for)
import Database.Persist.Sqlite (PersistValue (..), SqlBackend, runSqlConn, withSqliteConn)
import qualified Database.Sqlite as Sqlite
import PraTactile.Array (Position (..), Shape (..), shapeCells)
import PraTactile.Object.Canonical
import PraTactile.Object.Named (Named (..), namedDescription)
import PraTactile.Object.Placement hiding (more)
import PraTactile.Object.Placement.Search
import PraTactile.Object.WingedEdge
import PraTactile.Store
import PraTactile.Store.Query
import System.FilePath ((</>))
import Test.CommandLine.Run (refuses, scripted)
import Test.Effort
import Test.Hspec hiding (before)
import Test.QuickCheck
import Test.Recognition.Object.Support
import Test.Store.Asking
import Test.Store.Homes

spec :: SpecWith Home
spec = describe "change" $ do
  it "objects come, go and are replaced as in the placement, and so do all look-ups" $
    \home ->
      withMaxSuccess (max 1 (cases home (byEffort 2 6)))
        . forAllBlind (vectorOf 3 ((,) <$> genStep <*> arbitrary))
        $ \steps -> ioProperty (stored (\path place -> walk path place steps) home)
  it "a refused change leaves the store as it was" $
    stored $ \path place -> do
      change path (adding 1 (placementSolids place))
        `shouldReturn` Right (Left (NotChanged (RepeatedObject "cube")))
      change path (removing ["sphere"])
        `shouldReturn` Right (Left (NotChanged (UnknownObject "sphere")))
      asked path $ \store -> storedPlacement store `shouldReturn` Right place
  -- A part that was made for the first place was decoded as "on no object".
  it "an object that returns elsewhere is reported with its first place until it lies there again" $
    stored $ \path _ -> do
      let (lid, other) = (box "lid" 30 30 40, box "other" 30 30 40)
          told purposely step = fmap (fmap snd) <$> changeRemembering path purposely step
          nothing = Right (Right Map.empty)
      told [] (adding 1 [lid]) `shouldReturn` nothing
      Right (Right whole) <- withStore path Nothing storedPlacement
      let first' = Map.filterWithKey (const . (== "lid")) (placesIn whole)
          elsewhere = Right (Right first')
          asBefore now =
            first NotChanged $
              placement
                (placementShape now)
                (placementPitch now)
                (placementSolids now ++ [lid])
                ( map layingOf (laidFaces now)
                    ++ map layingOf (filter ((== "lid") . faceObject . laidFace) (laidFaces whole))
                )
      map length (Map.elems first') `shouldBe` [4]
      told [] (removing ["lid"]) `shouldReturn` nothing
      -- It takes the place of the lid, which cannot lie there then.
      told [] (adding 1 [other]) `shouldReturn` nothing
      told [] (adding 1 [lid]) `shouldReturn` elsewhere
      told [] (removing ["lid"]) `shouldReturn` nothing
      told [] (adding 1 [lid]) `shouldReturn` elsewhere
      told [] (removing ["lid", "other"]) `shouldReturn` nothing
      told [] asBefore `shouldReturn` nothing
      asked path $ \store ->
        fmap placesIn <$> storedPlacement store `shouldReturn` Right (placesIn whole)
      -- Replaced by another object of its name.
      told [] (removing ["lid"] >=> adding 1 [box "lid" 40 40 40]) `shouldReturn` elsewhere
      told [] (removing ["lid"] >=> adding 1 [other]) `shouldReturn` nothing
      -- On purpose, so that this is its place from now on.
      told ["lid"] (adding 1 [lid]) `shouldReturn` nothing
      told [] (removing ["lid"]) `shouldReturn` nothing
      told [] (adding 1 [lid]) `shouldReturn` nothing
  it "a store that predates the memory of places works as before, and begins to remember" $
    \home -> flip stored home $ \path place -> do
      execute home path ["DROP TABLE former_laying"]
      asked path $ \store -> storedPlacement store `shouldReturn` Right place
      Right (Right _) <- change path (adding 1 [box "lid" 40 40 40])
      Right (Right _) <- change path (removing ["cube"])
      Right (Right (now, former)) <- changeRemembering path [] (adding 1 [box "cube" 40 40 40])
      Map.keys former `shouldBe` ["cube"]
      asked path $ \store -> storedPlacement store `shouldReturn` Right now
  it "some objects are read as they are among all, and an unknown one is refused" $
    stored $ \path place -> asked path $ \store -> do
      storedNear store canonicalWindow everyPosition `shouldReturn` Right place
      for_ (placementSolids place) $ \body -> do
        let name = solidName body
            others = [solidName other | other <- placementSolids place, solidName other /= name]
        storedObjects store [name] `shouldReturn` first (error . show) (removing others place)
      for_ [0 .. length (laidFaces place) + 1] (firstRead store place)
      storedObjects store ["cube", "sphere"]
        `shouldReturn` Left (NotInStore (UnknownObject "sphere"))
  it "writers of one store wait for each other" $
    stored $ \path _ -> do
      _ <- change path (removing ["parallelepiped"])
      done <- for [1 .. 6 :: Int] $ \i -> do
        end <- newEmptyMVar
        let new = box ("box" ++ show i) 30 40 50
        _ <- forkIO (change path (adding 1 [new]) >>= putMVar end)
        pure end
      outcomes <- traverse takeMVar done
      for_ outcomes (`shouldSatisfy` either (const False) (either (const False) (const True)))
      Right (Right place) <- withStore path Nothing storedPlacement
      sort (map (objectText . solidName) (placementSolids place))
        `shouldBe` sort ("cube" : ["box" ++ show i | i <- [1 .. 6 :: Int]])
  it "a store that is being replaced answers as before or as after" $
    stored $ \path place -> do
      let fewer = either (error . show) id (removing ["cube"] place)
          at = Position 6 5
          there one = whereabouts one canonicalWindow at
      end <- newEmptyMVar
      _ <- forkIO $ do
        for_ (take (byEffort 6 12) (cycle [fewer, place])) $ \other ->
          create path "profile" other `shouldReturn` Right ()
        putMVar end ()
      let asking = do
            unfinished <- isEmptyMVar end
            found <- withStore path Nothing (\store -> storedWhereabouts store canonicalWindow at)
            found
              `shouldSatisfy` (`elem` map (Right . Right . there) [fewer, place])
            when unfinished asking
      asking
  where
    walk _ _ [] = pure ()
    walk path place ((step, NonNegative reading) : others) = do
      let outcome = step place
      changed <- change path step
      changed `shouldBe` Right outcome
      let now = either (const place) id outcome
      asked path $ \store -> do
        storedPlacement store `shouldReturn` Right now
        for_ somePositions $ \at ->
          storedWhereabouts store canonicalWindow at
            `shouldReturn` Right (whereabouts now canonicalWindow at)
        for_ (laidFaces now) $ \laid ->
          storedPosition store (laidFace laid) (Position 0 0)
            `shouldReturn` first NotInStore (arrayPosition now (laidFace laid) (Position 0 0))
        firstRead store now (reading `mod` (length (laidFaces now) + 2))
      walk path now others
    -- The first faces are the first of all, and everything within reach of them is the same.
    firstRead store place count = do
      let reach = Shape 1 2
      found <- storedFirst store count reach
      for_ found $ \some -> do
        take count (laidFaces some) `shouldBe` take count (laidFaces place)
        for_ (take count (laidFaces place)) $ \laid ->
          for_ (near reach (placementShape place) (laidAt laid) (laidGrid laid)) $ \at ->
            whereabouts some (Shape 1 1) at `shouldBe` whereabouts place (Shape 1 1) at
      either (expectationFailure . show) (const (pure ())) found
    near (Shape down across) (Shape high wide) (Position r c) (Shape tall broad) =
      [ Position ((r + high - down + i) `mod` high) ((c + wide - across + j) `mod` wide)
        | Position i j <- shapeCells (Shape (tall + 2 * down) (broad + 2 * across))
      ]

-- | Tests the promises about files only.
inFiles :: Spec
inFiles = describe "change of a file" $ do
  it "a refused change leaves the file as it was, to the byte" $
    storedInFile $ \path place -> do
      before <- Bytes.readFile path
      change path (adding 1 (placementSolids place))
        `shouldReturn` Right (Left (NotChanged (RepeatedObject "cube")))
      change path (removing ["sphere"])
        `shouldReturn` Right (Left (NotChanged (UnknownObject "sphere")))
      Bytes.readFile path `shouldReturn` before
  -- Decoding looks up every place that a press may show, on a small array all of them. With a
  -- statement for each cell that took 25 times as long as the recognition.
  it "all cells are looked up with at most two statements for each row of the array" $
    storedInFile $ \path place -> do
      statements <- statementsOn path $ do
        found <- runExceptT (selectNear shape canonicalPitch canonicalWindow everyPosition)
        liftIO (found `shouldBe` Right place)
      length statements `shouldSatisfy` (<= 2 * fromIntegral (rows shape))
  it "every statement of a look-up searches an index" $
    storedInFile $ \path place -> do
      statements <-
        statementsOn path $ do
          _ <- runExceptT selectSheet
          forM_ [Position 6 5, Position 14 16, Position 3 3] $ \at ->
            runExceptT (selectWhereabouts (Shape 15 17) canonicalPitch canonicalWindow at)
          _ <- runExceptT (selectFirstLaid (Shape 15 17) canonicalPitch 2 (Shape 1 1))
          forM_ (map laidFace (laidFaces place)) $ \face ->
            runExceptT (selectPosition (Shape 15 17) face (Position 1 1))
          let unknown = Face "sphere" (readFaceName "A B C")
          _ <- runExceptT (selectPosition (Shape 15 17) unknown (Position 1 1))
          runExceptT (selectNear shape canonicalPitch canonicalWindow [Position 6 5])
      length (nub statements) `shouldSatisfy` (> 8)
      for_ (nub statements) $ \asked_ -> do
        plan <- planOf path (decodeUtf8 asked_)
        (asked_, plan) `shouldSatisfy` all ("SEARCH" `Text.isPrefixOf`) . snd
  it "objects are added where a placement has them; without one, other places are reported" $
    inFolder $ \folder -> do
      let objects arguments = scripted folder ("pra-tactile objects --database a " ++ arguments)
          listed = (\(status, out, _) -> (status, sort (lines out))) <$> objects ""
      (0, _, _) <- scripted folder "pra-tactile objects --write a"
      (0, _, "") <- objects "--add lid=box:30x30x40"
      (0, _, "") <- objects "--export all.json"
      before <- listed
      (2, "", twice) <- objects "--add lid=box:30x30x40"
      twice `shouldSatisfy` ("--replace" `isInfixOf`)
      (0, _, "") <- objects "--remove lid"
      (0, _, "") <- objects "--add other=box:30x30x40"
      (0, out, err) <- objects "--add lid=box:30x30x40 --json"
      out `shouldSatisfy` ("\"elsewhere\":[\"lid\"]" `isInfixOf`)
      err `shouldSatisfy` ("lid lay elsewhere before: V" `isInfixOf`)
      length (lines err) `shouldBe` 1
      -- The advice, followed: the obstacle is named, and then the object lies where it lay.
      (0, _, "") <- objects "--remove lid"
      (1, inTheWay, "") <- objects "--add --placement all.json lid"
      inTheWay `shouldSatisfy` ("claim the same cells" `isInfixOf`)
      (0, _, "") <- objects "--remove other"
      (0, _, "") <- objects "--add --placement all.json lid=box:30x30x40"
      listed `shouldReturn` before
      (0, _, "") <- objects "--replace --placement all.json"
      listed `shouldReturn` before
      for_
        [ ("--add --placement all.json box:30x30x30", "no object box"),
          ("--replace --placement all.json cube=box:30x30x30", "another object in all.json"),
          ("--remove --placement all.json cube", "--remove lays none"),
          ("--placement all.json --at 4,5", "--add and --replace"),
          ("--add --placement none.json cube", "none.json")
        ]
        $ \(arguments, why) -> objects arguments >>= (`refuses` why)
  where
    shape = Shape 15 17

-- | The statements of a look-up in a file, except those of transactions.
statementsOn :: FilePath -> ReaderT SqlBackend IO a -> IO [Bytes.ByteString]
statementsOn path lookUp = do
  said <- newIORef []
  let logged _ _ _ text = modifyIORef said (fromLogStr text :)
  _ <- flip runLoggingT logged . withSqliteConn (Text.pack path) $ liftIO . runSqlConn lookUp
  filter ("SELECT" `Bytes.isPrefixOf`) . map (Bytes.takeWhile (/= ';')) <$> readIORef said

-- | The places of a placement's objects, as a store remembers them.
placesIn :: Placement -> Former
placesIn place =
  Map.map sort . Map.fromListWith (++) $
    [ (faceObject face, [FormerFace (faceText (faceName face)) (laidAt laid) (laidGrid laid)])
      | laid <- laidFaces place,
        let face = laidFace laid
    ]

-- | The database's plan for a query, a text for each table.
planOf :: FilePath -> Text.Text -> IO [Text.Text]
planOf path question = bracket (Sqlite.open (Text.pack path)) Sqlite.close $ \connection -> do
  let explained = Sqlite.prepare connection ("EXPLAIN QUERY PLAN " <> question)
  bracket explained Sqlite.finalize $ \asked_ ->
    let steps =
          Sqlite.step asked_ >>= \more -> case more of
            Sqlite.Row -> do
              values <- Sqlite.columns asked_
              ([text | PersistText text <- drop 3 values] ++) <$> steps
            Sqlite.Done -> pure []
     in steps

-- | A change of a placement.
genStep :: Gen (Placement -> Either NotChanged Placement)
genStep = do
  name <- elements ["a", "b", "cube", "lid", "parallelepiped"]
  sides <- vectorOf 3 (choose (26, 150))
  let new = case sides of
        [x, y, z] -> [box name x y z]
        _ -> []
  elements
    [ adding 1 new,
      removing [ObjectName name],
      removing [ObjectName name] >=> adding 1 new,
      first NotChanged . turnedRound
    ]
  where
    -- The same objects and faces, the last ones first.
    turnedRound place =
      placement
        (placementShape place)
        (placementPitch place)
        (reverse (placementSolids place))
        (reverse (map layingOf (laidFaces place)))

box :: String -> Integer -> Integer -> Integer -> Solid
box name x y z =
  either (error . show) id . solid $
    (namedDescription (Box (fromInteger x) (fromInteger y) (fromInteger z)))
      { describedName = ObjectName name
      }

stored :: (String -> Placement -> Expectation) -> Home -> Expectation
stored test home = thePlacement $ \place -> do
  path <- newName home
  create path "profile" place `shouldReturn` Right ()
  test path place

storedInFile :: (FilePath -> Placement -> Expectation) -> Expectation
storedInFile test = inFolder $ \folder -> thePlacement $ \place -> do
  let path = folder </> "a.sqlite"
  create path "profile" place `shouldReturn` Right ()
  test path place
