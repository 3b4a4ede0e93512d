{-# OPTIONS_HADDOCK hide #-}

-- | The answer of a located grid: the windows of the array that it shows, and each symbol's
-- position.
module PraTactile.Recognise.Finding
  ( Finding (..),
    ReadWindow (..),
    SymbolPlace (..),
    findingAt,
  )
where

import Data.List (nub, sortOn)
import Data.Map.Strict (Map)
import qualified Data.Map.Strict as Map
import Data.Maybe (isJust, listToMaybe, mapMaybe)
import Data.Ord (Down (..))
import Data.Set (Set)
import qualified Data.Set as Set
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Field (KnownField, toCode)
import PraTactile.Geometry (columnPitch, rotated, rowPitch)
import PraTactile.Object.Placement
import PraTactile.Recognise.GridLocation
import PraTactile.Recognise.Reading
import PraTactile.Recognise.Recogniser
import PraTactile.Segmentation.Lattice (ClusterCell)
import PraTactile.Symmetry

-- | The windows and symbols of composites that were located.
data Finding = Finding
  { -- | the orientation in which the face is seen
    foundOrientation :: Symmetry,
    -- | the first complete window, row by row. Without a complete one, the first window among those
    -- with the most recognised symbols, preferably one that lies on their face.
    foundWindow :: ReadWindow,
    -- | all complete windows, row by row
    foundWindows :: [ReadWindow],
    -- | the places of the symbols, by 'readNumber'
    foundPlaces :: Map Int SymbolPlace
  }
  deriving stock (Eq, Show)

-- | A window of the array, as it was read.
data ReadWindow = ReadWindow
  { -- | the position in the array of its upper left cell
    windowPosition :: Position,
    -- | its classes row by row, as seen on the face; 'Nothing' if the recognised symbol is not the
    -- array's, and without a symbol
    windowClasses :: [[Maybe Int]],
    -- | its centre, estimated from the symbols in it that were seen; coordinates as in 'readAt'
    windowSeenAt :: (Double, Double),
    -- | the faces that lie there. If all recognised symbols are on one face that is smaller than
    -- the window, then that face.
    windowWhereabouts :: Whereabouts
  }
  deriving stock (Eq, Show)

-- | A symbol's position in the array.
data SymbolPlace = SymbolPlace
  { -- | its cell
    symbolCell :: Position,
    -- | the array's class in that cell
    symbolExpected :: Int
  }
  deriving stock (Eq, Show)

-- | The finding for a located grid. Arguments: the recogniser; the angle of the symbols beyond
-- quarter turns, in degrees clockwise; the location of the grid; the position in the array of the
-- grid's upper left cell. 'Nothing' if there is no window.
findingAt :: KnownField k => Recogniser k -> Double -> GridLocation -> Position -> Maybe Finding
findingAt reader skew location position = do
  window <- listToMaybe (if null complete then incomplete else complete)
  pure
    Finding
      { foundOrientation = locationOrientation location,
        foundWindow = window,
        foundWindows = complete,
        foundPlaces =
          Map.fromList
            [ (readNumber s, place)
              | (cell, here) <- Map.toList cells,
                Just place <- [placeOf cell],
                s <- here
            ]
      }
  where
    cells = locationCells location
    placeOf cell = (\(p, a) -> SymbolPlace p (toCode a)) <$> cellFrom reader position cell
    place0 = fmap symbolCell . placeOf
    -- Cells with a symbol, known or likeliest, that agrees with the array.
    right = agreeingBy readClass
    likely = agreeingBy (Just . readLikeliest)
    agreeingBy said = Map.mapMaybeWithKey (agreeing said) cells
    agreeing said cell here = do
      expected <- symbolExpected <$> placeOf cell
      if any ((== Just (locationOrientation location, expected)) . said) here
        then Just expected
        else Nothing
    windowsFrom (i0, j0) =
      [ ((i, j), window)
        | i <- [i0 .. fst end],
          j <- [j0 .. snd end],
          Just window <- [windowIn reader skew location right place0 (i, j)]
      ]
    end = (maximum (0 : map fst (Map.keys cells)), maximum (0 : map snd (Map.keys cells)))
    complete = filter (all (all isJust) . windowClasses) (map snd (windowsFrom (0, 0)))
    incomplete =
      mostFelt
        (recogniserWindow reader)
        (facesAt (recogniserPlacement reader) . mapMaybe place0)
        (Map.keysSet (if null right then likely else right))
        (windowOf (recogniserPlacement reader) (recogniserWindow reader))
        windowsFrom

-- | Windows of this shape when none is complete, those with the most of the recognised cells first.
-- If all recognised cells lie on one face, only windows on that face count, even if they begin
-- before the grid. On a face smaller than a window, the windows that begin on it count.
mostFelt ::
  Shape ->
  ([ClusterCell] -> [LaidFace]) ->
  Set ClusterCell ->
  (LaidFace -> ReadWindow -> Maybe ReadWindow) ->
  (ClusterCell -> [(ClusterCell, ReadWindow)]) ->
  [ReadWindow]
mostFelt shape facesOf known onIt windowsFrom = case facesOf (Set.toList known) of
  [laid]
    | those@(_ : _) <- filter ((== Just (laidFace laid)) . faceOf) reaching -> those
    | those@(_ : _) <- mapMaybe (onIt laid) reaching -> those
  _ -> map snd (sortOn (Down . felt) (windowsFrom (0, 0)))
  where
    (high, wide) = (fromIntegral (rows shape), fromIntegral (columns shape))
    reaching =
      map snd . sortOn (Down . felt) . filter ((> 0) . fst . felt) $
        windowsFrom (1 - high, 1 - wide)
    felt ((i, j), window) =
      ( length
          [ ()
            | (i', j') <- Set.toList known,
              i' >= i && i' < i + high && j' >= j && j' < j + wide
          ],
        isJust (faceOf window)
      )
    faceOf window = case windowWhereabouts window of
      OnFace place -> Just (placeFace place)
      _ -> Nothing

-- | A window that begins on this face, located on the face even if it reaches beyond it.
windowOf :: Placement -> Shape -> LaidFace -> ReadWindow -> Maybe ReadWindow
windowOf place shape laid window =
  (\on -> window {windowWhereabouts = OnFace on})
    <$> placeFrom place laid shape (windowPosition window)

-- | The faces on which these cells of the array lie.
facesAt :: Placement -> [Position] -> [LaidFace]
facesAt place positions =
  nub
    [ laid
      | at <- positions,
        OnFace on <- [whereabouts place (Shape 1 1) at],
        let Face object named = placeFace on,
        Right laid <- [findFace place object named]
    ]

-- | The window whose upper left cell is the given cell of the grid. Other arguments: the
-- recogniser; the symbols' angle; the location of the grid; the class in each cell that agrees with
-- the array; the position in the array of a cell.
windowIn ::
  Recogniser k ->
  Double ->
  GridLocation ->
  Map ClusterCell Int ->
  (ClusterCell -> Maybe Position) ->
  ClusterCell ->
  Maybe ReadWindow
windowIn reader skew location right place0 (i, j) = do
  position <- place0 (i, j)
  pure
    ReadWindow
      { windowPosition = position,
        windowClasses = [[Map.lookup cell right | cell <- line] | line <- block],
        windowSeenAt = centroid centres,
        windowWhereabouts = whereabouts (recogniserPlacement reader) window position
      }
  where
    window = recogniserWindow reader
    block = [[(i + di, j + dj) | dj <- [0 .. wide - 1]] | di <- [0 .. high - 1]]
    (high, wide) = (fromIntegral (rows window), fromIntegral (columns window))
    centres =
      [ centreFrom s cell
        | line <- block,
          cell <- line,
          Just here <- [Map.lookup cell (locationCells location)],
          s <- here
      ]
    -- The window's centre, as the symbol in this cell implies it.
    centreFrom s (i', j') =
      let (x, y) = readAt s
          across = columnPitch * (fromIntegral (j' - j) - (fromIntegral (columns window) - 1) / 2)
          down = rowPitch * (fromIntegral (i' - i) - (fromIntegral (rows window) - 1) / 2)
          (dx, dy) = rotated skew (onOffset (locationOrientation location) (across, down))
       in (x - dx, y - dy)
