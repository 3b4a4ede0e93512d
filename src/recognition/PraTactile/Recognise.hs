{-# LANGUAGE DerivingStrategies #-}
-- | The whole way from a composite tactile image to the object's face: symbols, their orientation, complete windows,
-- the position in the array, and what lies there (the paper's sections II and IV).
--
-- Nothing is guessed: each symbol must be recognised in exactly one orientation, all symbols must agree on it, all
-- windows must agree on the position, and every other case is a typed refusal.
module PraTactile.Recognise
  ( -- * The recogniser
    Recogniser
  , recogniser
  , recogniserPlacement
    -- * Recognition
  , Recognition (..)
  , recognise
    -- * Symbols
  , ReadSymbol (..)
  , Orientation (..)
  , orientationDegrees
    -- * Windows
  , ReadWindow (..)
    -- * The answer
  , Answer (..)
  , Refusal (..)
  , refusals
  , refusalName
  ) where

import Data.Bifunctor (first)
import Data.List (nub)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (mapMaybe)

import PraTactile.Array (Position (..), PseudorandomArray, Shape (..), Surface (..))
import PraTactile.Classify.Network (Network, NetworkError, Verdict (..), classify, standardThresholds)
import PraTactile.Field (KnownField)
import PraTactile.Image (halfTurn)
import PraTactile.Locate
import PraTactile.Object.Placement
  (Pitch (..), Placement, Whereabouts, placementPitch, placementShape, whereabouts)
import PraTactile.Probe (taxelPitch)
import PraTactile.Segment (SymbolImage (..), segment, segmentedSymbols)
import PraTactile.Segment.Lattice (Cell, Cluster, arrange, halfTurned)
import qualified PraTactile.Segment.Lattice as Lattice
import PraTactile.Stitch (Composite)
import PraTactile.Symbol (elementOfClass)
import PraTactile.Window (Mask, Packing (..), maskExtent)

-- | All that recognition needs: the memory table of the array's windows, the placement of the faces, and the trained
-- network.
data Recogniser k = Recogniser
  { recogniserTable :: Table k
  , recogniserWindow :: Shape
  , recogniserPlacement :: Placement   -- ^ the placement that positions are looked up in
  , recogniserNetwork :: Network
  }

-- | A recogniser for rectangular windows on an array, which is a torus to it; refuses what 'buildTable' refuses.
recogniser :: KnownField k => PseudorandomArray k -> Mask -> Placement -> Network -> Either LocateError (Recogniser k)
recogniser array window layout network = do
  table <- buildTable MostSignificantFirst Torus array window
  pure (Recogniser table (maskExtent window) layout network)

-- | How the composite lies on the face.
data Orientation
  = Upright      -- ^ the composite's rows run as the face's do
  | HalfTurned   -- ^ the composite shows the face turned by 180 degrees
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | Clockwise, in degrees: how the face appears turned in the composite.
orientationDegrees :: Orientation -> Int
orientationDegrees Upright = 0
orientationDegrees HalfTurned = 180

-- | A symbol that was cut out of the composite and what the network said of it.
data ReadSymbol = ReadSymbol
  { readImage :: SymbolImage            -- ^ where it lies in the composite, and its 8-by-12 image
  , readClass :: Maybe (Orientation, Int) -- ^ orientation and class, if the network knows it in exactly one orientation
  }

-- | A complete window that was found.
data ReadWindow = ReadWindow
  { windowPosition :: Position          -- ^ in the array
  , windowClasses :: [[Int]]            -- ^ row by row, as seen on the face
  , windowSeenAt :: (Double, Double)    -- ^ in the composite: pixels to the right and down
  , windowWhereabouts :: Whereabouts    -- ^ what lies there
  }

-- | What was recognised, whether or not it led to an answer.
data Recognition = Recognition
  { recognisedSymbols :: [ReadSymbol]   -- ^ every complete symbol of the composite
  , recognisedAnswer :: Either Refusal Answer
  }

-- | The answer.
data Answer
  = -- | The orientation of the composite and all complete windows in reading order, which agree with each other; at
    -- least one.
    Found Orientation ReadWindow [ReadWindow]
  | -- | The orientation, and the several positions of the patch's upper left cell that fit what was recognised (only
    -- where the array lacks the window property).
    Several Orientation [Position]

-- | Why there is no answer; each has a stable name, 'refusalName'.
data Refusal
  = NoSymbols              -- ^ the composite shows no complete symbol
  | SymbolsUnclear         -- ^ there are symbols, but the network recognised none
  | OrientationContradicts -- ^ symbols disagree about the orientation of the grid
  | GridContradicts        -- ^ the symbols do not lie on one grid of the array's pitch
  | WindowsContradict      -- ^ separate groups of symbols lead to different places
  | NotLocated Reason      -- ^ the recognised cells lead to no position
  deriving stock (Eq, Show)

-- | All refusals.
refusals :: [Refusal]
refusals =
  [NoSymbols, SymbolsUnclear, OrientationContradicts, GridContradicts, WindowsContradict] ++ map NotLocated reasons

-- | The stable name of a refusal, as JSON has it.
refusalName :: Refusal -> String
refusalName refusal = case refusal of
  NoSymbols -> "no-symbols"
  SymbolsUnclear -> "symbols-unclear"
  OrientationContradicts -> "orientation-contradiction"
  GridContradicts -> "grid-contradiction"
  WindowsContradict -> "windows-contradiction"
  NotLocated reason -> reasonName reason

-- | Recognise what a composite image shows. Refuses, through 'Either', only a network that does not fit the symbols.
recognise :: KnownField k => Recogniser k -> Composite -> Either NetworkError Recognition
recognise reader composite = do
  groups <- traverse (readCluster (recogniserNetwork reader)) (arrange (segmentedSymbols (segment composite)))
  pure Recognition
    { recognisedSymbols = concatMap snd groups
    , recognisedAnswer = answerFrom reader groups
    }

-- | A group of neighbouring symbols: their cells on a grid, if they lie on one, and the symbols themselves.
type Group = (Maybe (Map Cell ReadSymbol), [ReadSymbol])

readCluster :: Network -> Cluster -> Either NetworkError Group
readCluster network cluster = case cluster of
  Lattice.Cluster cells -> do
    grid <- traverse (readSymbol network) cells
    pure (Just grid, Map.elems grid)
  Lattice.Contradiction _ images -> (,) Nothing <$> traverse (readSymbol network) images

-- | Ask the network about a symbol's image in both orientations; it must know it in exactly one of them.
readSymbol :: Network -> SymbolImage -> Either NetworkError ReadSymbol
readSymbol network image = do
  upright <- classify standardThresholds network (symbolPixels image)
  turned <- classify standardThresholds network (halfTurn (symbolPixels image))
  pure (ReadSymbol image (inOneOrientation upright turned))
  where
    inOneOrientation (Recognised _ _) (Recognised _ _) = Nothing
    inOneOrientation (Recognised c _) _ = Just (Upright, c)
    inOneOrientation _ (Recognised c _) = Just (HalfTurned, c)
    inOneOrientation _ _ = Nothing

answerFrom :: KnownField k => Recogniser k -> [Group] -> Either Refusal Answer
answerFrom reader groups = do
  orientation <- case nub [o | Just (o, _) <- map readClass symbols] of
    _ | null symbols -> Left NoSymbols
    [] -> Left SymbolsUnclear
    [o] -> Right o
    _ -> Left OrientationContradicts
  grids <- maybe (Left GridContradicts) Right (traverse fst groups)
  combine reader orientation [ (grid, locateGrid reader grid) | grid <- map (seenOnFace orientation) grids ]
  where
    symbols = concatMap snd groups

-- | A group of symbols as seen on the face, row by row, with gaps.
seenOnFace :: Orientation -> Map Cell ReadSymbol -> [[Maybe ReadSymbol]]
seenOnFace orientation symbols = [ [ Map.lookup (i, j) cells | j <- extent snd ] | i <- extent fst ]
  where
    cells = case orientation of
      Upright -> symbols
      HalfTurned -> halfTurned symbols
    extent part = [0 .. maximum (-1 : map part (Map.keys cells))]

-- | Where a group's recognised cells lie in the array.
locateGrid :: KnownField k => Recogniser k -> [[Maybe ReadSymbol]] -> Outcome
locateGrid reader grid = either (const (Refused NoCompleteWindow)) (locatePatch (recogniserTable reader)) cells
  where
    cells = first (const ()) (traverse (traverse element) grid) >>= first (const ()) . patch
    element symbol = traverse (elementOfClass . snd) (symbol >>= readClass)

-- | One answer from the groups': those without a complete window do not count, the others must agree.
combine :: Recogniser k -> Orientation -> [([[Maybe ReadSymbol]], Outcome)] -> Either Refusal Answer
combine reader orientation groups
  | contradiction : _ <- [ r | (_, Refused r) <- groups, r `notElem` incomplete ] = Left (NotLocated contradiction)
  | window : windows <- found =
      if all (agrees reader orientation window) windows then Right (Found orientation window windows) else Left WindowsContradict
  | positions : _ <- [ ps | (_, Ambiguous ps _) <- groups ] = Right (Several orientation positions)
  | otherwise = Left (NotLocated NoCompleteWindow)
  where
    incomplete = [TooFewCells, NoCompleteWindow]
    found = concat [ mapMaybe (windowIn reader grid position) offsets | (grid, Located position offsets) <- groups ]

-- | The complete window at an offset of a located group.
windowIn :: Recogniser k -> [[Maybe ReadSymbol]] -> Position -> Position -> Maybe ReadWindow
windowIn reader grid (Position i j) (Position di dj) = do
  cells <- traverse (traverse known) (block di dj grid)
  let centres = map fst (concat cells)
      position = Position ((i + di) `mod` rows shape) ((j + dj) `mod` columns shape)
  pure ReadWindow
    { windowPosition = position
    , windowClasses = map (map snd) cells
    , windowSeenAt = (average (map fst centres), average (map snd centres))
    , windowWhereabouts = whereabouts layout window position
    }
  where
    layout = recogniserPlacement reader
    shape = placementShape layout
    window = recogniserWindow reader
    block top left = map (part left (columns window)) . part top (rows window)
    part from count = take (fromIntegral count) . drop (fromIntegral from)
    known symbol = do
      s <- symbol
      (_, c) <- readClass s
      pure (symbolCentre (readImage s), c)
    average xs = sum xs / fromIntegral (length xs)

-- | Do two windows lie in the composite as their positions lie in the array? To half a cell's pitch.
agrees :: Recogniser k -> Orientation -> ReadWindow -> ReadWindow -> Bool
agrees reader orientation a b = near columns column fst pitchRight && near rows row snd pitchDown
  where
    layout = recogniserPlacement reader
    near size index along size1 =
      let cells = fromIntegral (index (windowPosition b)) - fromIntegral (index (windowPosition a)) :: Double
          taxels = sign * (along (windowSeenAt b) - along (windowSeenAt a))
          apart = taxels / (fromRational (size1 (placementPitch layout)) / taxelPitch) - cells
          wrapped = apart - whole * fromIntegral (round (apart / whole) :: Integer)
          whole = fromIntegral (size (placementShape layout))
      in abs wrapped < 0.5
    sign = case orientation of
      Upright -> 1
      HalfTurned -> -1
