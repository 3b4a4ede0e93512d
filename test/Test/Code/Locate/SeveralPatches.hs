-- | Several patches at known displacements: how many there may be, and which of them do not belong.
-- Where they are together is held by "Test.Code.Locate.EveryDecoderAsDefined".
module Test.Code.Locate.SeveralPatches (spec) where

import Control.Monad (forM_)
import Data.Maybe (fromMaybe)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Field.Named
import PraTactile.Locate
import PraTactile.Locate.Joint
import PraTactile.Locate.Patch
import PraTactile.Symmetry
import Test.Code.Generators
import Test.Code.Locate.Asking
import Test.Hspec
import Test.Paper

spec :: Spec
spec = do
  describe "joining" joiningSpec
  describe "patches displaced by one cell" displacedSpec
  describe "probabilities" beliefSpec
  it "refuses no patches at all, and patches too far apart before it takes memory" $ do
    patches <- scene (Position 6 5) [((0, 0), (0, 0), 0), ((far, far), (0, 0), 0)]
    answered <- paperAsk NearestDecoder
    answered [identity] Guaranteed 0 (symbolsOf patches)
      `shouldBe` Left
        (LocatorPatch (PatchTooLarge (fromInteger (far + 2) ^ (2 :: Int)) (2 ^ (20 :: Int))))
    answered [identity] Guaranteed 0 [] `shouldBe` Left (LocatorPatch PatchEmpty)
  where
    far = 10 ^ (9 :: Int)

joiningSpec :: Spec
joiningSpec = do
  it "takes at most 100 patches" $ do
    let many n = replicate n ((3, 4), patchOf (Shape 1 1) [(Position 0 0, 'a')])
    fmap (length . jointOffsets) (joint agreedSymbol (many 100)) `shouldSatisfy` (== Right 100)
    either Just (const Nothing) (joint agreedSymbol (many 101))
      `shouldBe` Just (PatchesTooMany 101 100)
  it "takes patches within a rectangle of at most 2^20 cells" $ do
    let single = patchOf (Shape 1 1) [(Position 0 0, 'a')]
        framed far =
          patchShape . jointPatch <$> joint agreedSymbol [((0, 0), single), (far, single)]
    framed (1023, 1023) `shouldBe` Right (Shape 1024 1024)
    framed (0, 1048576) `shouldBe` Left (PatchTooLarge 1048577 1048576)

displacedSpec :: Spec
displacedSpec = do
  it "are named, whichever patch and direction it is, and the others are located" $
    forM_ someplaces $ \p -> forM_ [0 .. 4] $ \astray -> forM_ aside $ \by -> do
      found <- nearestOf (UpTo 4) p (displaced astray by fivePlaces)
      (place found, inconsistent found) `shouldBe` ([p], [astray])
  it "are named even if nothing is corrected, so that the whole is not located" $
    forM_ aside $ \by -> forM_ [0 .. 3] $ \astray -> do
      found <- nearestOf (UpTo 0) (Position 6 5) (displaced astray by (take 4 fivePlaces))
      (place found, inconsistent found) `shouldBe` ([], [astray])
  it "are both named if there are only two, since neither is more credible" $ do
    found <- nearestOf Guaranteed (Position 6 5) (zip3 [(0, 0), (3, 0)] [(0, 0), (4, 0)] [0, 0])
    (place found, inconsistent found) `shouldBe` ([], [0, 1])
  it "are the minority: two of five if three agree, all of four if they agree in pairs" $ do
    found <-
      nearestOf (UpTo 0) (Position 6 5) $
        zip3 fivePlaces [(0, 0), (0, 5), (4, 0), (4, 4), (7, 2)] zeros
    (place found, inconsistent found) `shouldBe` ([], [1, 4])
    torn <-
      nearestOf Guaranteed (Position 6 5) $
        zip3 fivePlaces [(0, 0), (0, 4), (5, 0), (5, 4)] zeros
    (place torn, inconsistent torn) `shouldBe` ([], [0, 1, 2, 3])
  it "are not named if all belong together, with the errors that each can correct alone" $ do
    array <- paperArray
    answered <- paperAsk NearestDecoder
    -- 4 x 4 patches, one cell of each wrong.
    patches <-
      sequence
        [ (,) (r, c)
            <$> right (patch (changed (2, 2) 1 (look array (Shape 4 4) (at (Position 6 5) (r, c)))))
          | (r, c) <- [(0, 0), (4, 3), (2, 7)]
        ]
    found <- right (answered [identity] Guaranteed 0 (symbolsOf patches))
    (place found, inconsistent found, wrongOf found) `shouldBe` ([Position 6 5], [], [1, 1, 1])
  it "are named in any common orientation" $ do
    array <- paperArray
    answered <- paperAsk NearestDecoder
    exactly <- paperAsk AlgebraDecoder
    forM_ rotations $ \o -> do
      -- The scene upright: 2 x 2 patches on a 9 x 9 board, the last of them from one row further
      -- down.
      let board = Shape 9 9
          corners = [((0, 0), 0), ((0, 5), 0), ((5, 0), 0), ((6, 6), 0), ((3, 3), 1)]
          -- A patch is seen where its cells are; its upper left is their least row and column.
          corner (i, j) =
            let cells =
                  [onPosition o board (at (Position 0 0) (i + a, j + b)) | a <- [0, 1], b <- [0, 1]]
             in (toInteger (minimum (map row cells)), toInteger (minimum (map column cells)))
      patches <-
        mapM
          ( \((i, j), down) ->
              (,) (corner (i, j))
                <$> right
                  (patch (onRows o (look array (Shape 2 2) (at (Position 6 5) (i + down, j)))))
          )
          corners
      found <- right (answered rotations (UpTo 4) 0 (symbolsOf patches))
      ([candidateSymmetry c | Unique c _ <- [answerOutcome found]], inconsistent found)
        `shouldBe` ([o], [4])
      -- Where nothing may be corrected, the algebra names the same one.
      exact <- right (exactly rotations Guaranteed 0 (symbolsOf patches))
      (answerOutcome exact, inconsistent exact) `shouldBe` (Refused Contradiction, [4])

beliefSpec :: Spec
beliefSpec = do
  it "that contradict each other make a disputed cell, which counts as unobserved" $ do
    found <- believed certainly [identity] 0.001 disputed
    ( candidatePosition <$> (answerPosterior found >>= posteriorBest),
      answerDisputed found,
      wrongOf found,
      inconsistent found
      )
      `shouldBe` (Just (Position 6 5), [Position 1 1], [0, 0, 0], [1])
  it "name a patch displaced by one cell, in any orientation" $
    forM_ aside $ \by -> forM_ [0 .. 4] $ \astray -> forM_ [[identity], rotations] $ \possible -> do
      found <- believed likely possible 0.02 (displaced astray by fivePlaces)
      (answerOutcome found, inconsistent found)
        `shouldBe` (Unique (Candidate identity (Position 6 5)) [], [astray])
  it "of no patches are refused" $ do
    answered <- paperAsk PosteriorDecoder
    answered [identity] Guaranteed 0.01 [] `shouldBe` Left (LocatorPatch PatchEmpty)
  where
    believed belief' possible tolerated patches = do
      answered <- paperAsk PosteriorDecoder
      given <- scene (Position 6 5) patches
      right . answered possible Guaranteed tolerated $
        map (fmap (fmap (Probabilities . belief'))) given
    -- What was seen is 0.997 probable.
    likely a =
      either (error . show) id $
        belief [if code == toCode a then 0.997 else 0.001 | code <- [0 .. 3]]

-- | Where a 2 x 2 patch is said to be, whence it was taken, and what was added to its first cell.
type Taken = ((Integer, Integer), (Integer, Integer), GF GF4)

-- | Five patches of which one was taken from aside.
displaced :: Int -> (Integer, Integer) -> [(Integer, Integer)] -> [Taken]
displaced astray (r, c) places =
  [ ((a, b), if i == astray then (a + r, b + c) else (a, b), 0)
    | (i, (a, b)) <- zip [0 ..] places
  ]

fivePlaces, aside :: [(Integer, Integer)]
fivePlaces = [(0, 0), (0, 4), (4, 0), (4, 4), (8, 2)]
aside = [(0, 1), (1, 0), (0, -1), (-1, 0)]

-- | Taken from where they are said to be.
inPlace :: [(Integer, Integer)] -> [GF GF4] -> [Taken]
inPlace places = zip3 places places

disputed :: [Taken]
disputed = inPlace [(0, 0), (1, 1), (0, 4)] [0, 1, 0]

zeros :: [GF GF4]
zeros = repeat 0

someplaces :: [Position]
someplaces = [Position 0 0, Position 6 5, Position 14 16]

-- | Patches of the paper's torus.
scene :: Position -> [Taken] -> IO (Patches (GF GF4))
scene from taken = do
  array <- paperArray
  sequence
    [ (,) said <$> right (patch (changed (0, 0) e (look array (Shape 2 2) (at from whence))))
      | (said, whence, e) <- taken
    ]

at :: Position -> (Integer, Integer) -> Position
at (Position r c) (i, j) = Position (wrapped 15 (toInteger r + i)) (wrapped 17 (toInteger c + j))
  where
    wrapped n k = fromInteger (k `mod` n)

-- | With this added to the symbol there.
changed :: (Int, Int) -> GF GF4 -> Cells -> Cells
changed there e cells =
  [ [if (i, j) == there then (+ e) <$> a else a | (j, a) <- zip [0 ..] line]
    | (i, line) <- zip [0 ..] cells
  ]

nearestOf :: Radius -> Position -> [Taken] -> IO Answer
nearestOf radius from taken = do
  answered <- paperAsk NearestDecoder
  scene from taken >>= right . answered [identity] radius 0 . symbolsOf

paperAsk ::
  DecoderName ->
  IO
    ( [Symmetry] ->
      Radius ->
      Double ->
      Patches (Cell GF4) ->
      Either LocatorError Answer
    )
paperAsk decoder = (\array m -> ask (Just decoder) (Torus, array, m)) <$> paperArray <*> paperWindow

place :: Answer -> [Position]
place found = [candidatePosition candidate | Unique candidate _ <- [answerOutcome found]]

-- | How many cells of each patch are wrong.
wrongOf :: Answer -> [Int]
wrongOf = map (fromMaybe 0 . patchWrong) . answerPatches

-- | The indices, from 0, of the patches that do not belong.
inconsistent :: Answer -> [Int]
inconsistent = map fst . filter (patchInconsistent . snd) . zip [0 ..] . answerPatches
