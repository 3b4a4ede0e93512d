{-# LANGUAGE OverloadedStrings #-}
{-# OPTIONS_HADDOCK hide #-}

-- | Random faces of solids laid on arrays, by the definition of what lies on a face.
module PraTactile.Conformance.Laws.Placements
  ( placements,
    impossible,
    windowOn,
  )
where

import Data.List (inits, nub, tails)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Conformance.Definition.Face
import PraTactile.Conformance.Laws.Draw (anyNatural)
import PraTactile.Conformance.Laws.Solids
import PraTactile.Conformance.Question
import PraTactile.Format.Object (WhereaboutsReport)
import PraTactile.Format.Placement (Drawing (..))
import PraTactile.Object.Description
import PraTactile.Object.Named
import PraTactile.Object.Placement (Face (..))
import Test.QuickCheck

-- | A window of a placement, mostly near a laid face.
windowOn :: Mapped -> Gen (Question WhereaboutsReport)
windowOn mapped = do
  (window, at) <-
    frequency $
      (1, (,) <$> sides <*> anywhere) :
      [(4, sides >>= near' cells) | cells@(_ : _) <- [concat taken]]
        ++ [(2, boxOf <$> elements faces) | faces@(_ : _) <- [taken]]
        ++ [ (2, boxOf <$> (shuffle faces >>= traverse elements . take 2))
             | faces@(_ : _ : _) <- [taken]
           ]
  pure (Whereabouts :? (mapped, window, at))
  where
    Shape high wide = mappedShape mapped
    sides = Shape <$> side <*> side
    side = fromInteger <$> frequency [(3, chooseInteger (1, 2)), (1, chooseInteger (1, 4))]
    taken = filter (not . null) (map cellsTaken (mappedLayings mapped))
    anywhere =
      oneof
        [Position <$> upTo (3 * high) <*> upTo (3 * wide), Position <$> anyNatural <*> anyNatural]
    upTo n = fromInteger <$> chooseInteger (0, toInteger n)
    -- A corner of the window is on a laid face or just beyond.
    near' cells window@(Shape tall broad) = do
      (r, c) <- elements cells
      i <- toInteger <$> elements [0, 1, tall - 1, tall]
      j <- toInteger <$> elements [0, 1, broad - 1, broad]
      pure (window, Position (fromInteger (max 0 (r - i))) (fromInteger (max 0 (c - j))))
    -- The bounding box of a face's cells, or of two cells of different faces.
    boxOf cells =
      let (top, left) = (max 0 (minimum (map fst cells)), max 0 (minimum (map snd cells)))
          size end from = fromInteger (1 + max from (maximum (map end cells)) - from)
       in (Shape (size fst top) (size snd left), Position (fromInteger top) (fromInteger left))

-- | The cells of the array that a laid face takes.
cellsTaken :: Drawing -> [(Integer, Integer)]
cellsTaken laid =
  [ (drawnRow laid + i, drawnColumn laid + j)
    | (i, line) <- zip [0 ..] (drawnCells laid),
      (j, '#') <- zip [0 ..] line
  ]

-- | Some faces of some solids, laid where there is room.
placements :: Gen Mapped
placements = do
  (high, wide) <- (,) <$> chooseInteger (1, 9) <*> chooseInteger (1, 9)
  pitch@(right, _) <- elements [(1, 1), (127 / 5, 127 / 4), (3 / 2, 2)]
  count <- chooseInt (1, 3)
  drawn <- mapM (body right) [1 .. count]
  -- Half of the time they have one form and size.
  alike <- arbitrary
  let objects
        | alike = [it {describedName = describedName other} | it <- take 1 drawn, other <- drawn]
        | otherwise = drawn
  walks <-
    nub
      <$> vectorOf
        4
        (elements [(describedName it, it, walk) | it <- objects, walk <- describedFaces it])
  layings <- foldr (\walk before -> before >>= laidBeside (high, wide) pitch walk) (pure []) walks
  pure (Mapped (Shape (fromInteger high) (fromInteger wide)) pitch objects layings)
  where
    body unit number = do
      shape <-
        elements
          [Box 4 3 2, Tetrahedron 5, LShape 4 2 5, Prism 5 3 3, Octahedron 4, Pyramid 5 4 3]
      k <- (* unit) <$> elements [1, 3 / 2, 7 / 5]
      it <- shuffledFaces (moved (scaled' k) (namedDescription shape))
      pure it {describedName = ObjectName ("o" ++ show (number :: Int))}
    scaled' k (Point x y z) = Point (k * x) (k * y) (k * z)

-- | The laid faces with one more, if a place for it is found.
laidBeside ::
  (Integer, Integer) ->
  (Rational, Rational) ->
  (ObjectName, Description, FaceName) ->
  [Drawing] ->
  Gen [Drawing]
laidBeside (high, wide) pitch (name, it, walk) before
  | any ((== walk) . faceName . drawnFace) (filter ((== name) . faceObject . drawnFace) before) =
    pure before
  | otherwise = case traverse (`lookup` describedVertices it) (faceVertices walk) >>= flat of
    Nothing -> pure before
    Just face -> do
      let room = roomFor face pitch
      less <- (,) <$> few <*> few
      margin <- frequency [(3, pure Nothing), (1, Just <$> elements [(1, 1), (1 / 3, 5 / 2)])]
      kept <- vectorOf 200 (frequency [(8, pure True), (1, pure False)])
      let size = (max 0 (fst room - fst less), max 0 (snd room - snd less))
          block = Block (maybe Middle From margin) pitch size
          drawn =
            [ [ if holds face block (r, c) && keep then '#' else '.'
                | (c, keep) <- zip [0 .. snd size - 1] keeps
              ]
              | (r, keeps) <- zip [0 .. fst size - 1] (inParts 20 kept)
            ]
          at (r, c) = Drawing (Face name walk) r c margin drawn
          free laid =
            not (null (cellsTaken laid))
              && and
                [ i >= 0 && i < high && j >= 0 && j < wide && (i, j)
                    `notElem` concatMap
                      cellsTaken
                      before
                  | (i, j) <- cellsTaken laid
                ]
      places <- vectorOf 12 ((,) <$> chooseInteger (-1, high) <*> chooseInteger (-1, wide))
      pure (before ++ take 1 (filter free (map at places)))
  where
    few = frequency [(3, pure 0), (1, pure 1)]
    inParts n values = case splitAt n values of
      (part, []) -> [part]
      (part, others) -> part : inParts n others

-- | The placement with an impossible change.
impossible :: Mapped -> Gen Mapped
impossible mapped =
  oneof $
    [ pure mapped {mappedPitch = (0, 1)},
      pure mapped {mappedShape = Shape 0 3},
      pure mapped {mappedObjects = concatMap (\it -> [it, it]) (mappedObjects mapped)},
      pure
        mapped
          { mappedObjects =
              map
                (\it -> it {describedFaces = drop 1 (describedFaces it)})
                (mappedObjects mapped)
          },
      pure mapped {mappedObjects = map reversed (mappedObjects mapped)}
    ]
      ++ [ do
             (before, laid, after) <- elements (eachOf layings)
             let (rs, cs) = unzip (cellsTaken laid)
                 byRows i = laid {drawnRow = drawnRow laid + i}
                 byColumns i = laid {drawnColumn = drawnColumn laid + i}
             changed <-
               elements
                 [ laid {drawnRow = rowsOf mapped},
                   laid {drawnColumn = -20},
                   -- Moved beyond an edge by a single row or column.
                   byRows (-1 - minimum rs),
                   byRows (rowsOf mapped - maximum rs),
                   byColumns (-1 - minimum cs),
                   byColumns (columnsOf mapped - maximum cs),
                   laid {drawnFace = (drawnFace laid) {faceObject = "nobody's"}},
                   laid {drawnFace = backwards (drawnFace laid)},
                   laid
                     { drawnCells =
                         drawnCells laid
                           ++ take
                             1
                             (map (const '#' <$>) (drawnCells laid))
                     },
                   laid {drawnCells = map ('#' :) (drawnCells laid)},
                   laid {drawnCells = []}
                 ]
             elements
               [ mapped {mappedLayings = before ++ [changed] ++ after},
                 -- The same face again, or another face on its cells.
                 mapped
                   { mappedLayings = layings ++ [laid {drawnFace = begunLater (drawnFace laid)}]
                   }
               ]
           | not (null layings)
         ]
      -- A margin that leaves the face.
      ++ [ do
             (before, laid, after) <- elements (eachOf layings)
             let changed = laid {drawnMargin = Just (-1 / 7, 0)}
             pure mapped {mappedLayings = before ++ [changed] ++ after}
           | not (null layings)
         ]
  where
    layings = mappedLayings mapped
    eachOf xs = [(before, x, after) | (before, x : after) <- zip (inits xs) (tails xs)]
    rowsOf it = let Shape high _ = mappedShape it in toInteger high
    columnsOf it = let Shape _ wide = mappedShape it in toInteger wide
    backwards (Face name (FaceName walk)) = Face name (FaceName (reverse walk))
    begunLater (Face name (FaceName walk)) = Face name (FaceName (drop 1 walk ++ take 1 walk))
