-- | Merges faces that lie in one plane and share sides. This restores faces that an exporter cut
-- into triangles.
--
-- A region is a set of faces that are connected by sides, in one plane and with one outer side. If
-- the rims of a region visit no vertex twice, it becomes one face, with a hole for each rim but one
-- ("PraTactile.Object.Rims"). If rims touch, each face, in the file's order, absorbs faces across
-- its sides one by one, as long as the result is a simple polygon. Afterwards two kinds of vertices
-- are removed: those on only two faces and straight between their neighbours, and those on no face.
-- The walk around a merged face begins at the first of its vertices.
module PraTactile.Object.Merge
  ( mergeCoplanar,
    mergeTriangles,
    mergeRegions,
    regionsOfPlanes,
    withoutHoles,
  )
where

import qualified Data.IntMap.Strict as IntMap
import qualified Data.IntSet as IntSet
import Data.List (foldl', sortOn)
import Data.Maybe (mapMaybe)
import qualified Data.Vector as V
import qualified Data.Vector.Unboxed as U
import PraTactile.Object.Description (cyclicPairs)
import PraTactile.Object.Mesh
import PraTactile.Object.Rims
import PraTactile.Object.Surface
import PraTactile.Object.Triangles
import PraTactile.Object.Vector

-- | Merges all faces of one plane. Faces that are not flat, or not well formed, stay unchanged.
mergeCoplanar :: Mesh -> Mesh
mergeCoplanar it = mergeRegions (regionsOfPlanes it) it

-- | Merges triangles of one plane, such as an exporter makes. Faces with more corners stay
-- unchanged.
mergeTriangles :: Mesh -> Mesh
mergeTriangles it
  | V.any triangle (meshWalks it) = mergeRegions (U.imap apart (regionsOfPlanes it)) it
  | otherwise = it
  where
    triangle walk = U.length walk == 3
    -- Each face that is not a triangle gets a number of its own.
    apart f region = if triangle (meshWalks it V.! f) then region else negate f - 1

-- | For each face the number of the plane region within which it may be merged.
regionsOfPlanes :: Mesh -> U.Vector Int
regionsOfPlanes it =
  U.imap
    (\f first -> if V.null (planes V.! f) then f else first)
    (firstAlike keyed)
  where
    keyed = V.imap (\f key -> if V.null key then Left f else Right (V.toList key)) planes
    planes = V.map planeOf (meshWalks it)
    planeOf walk = if ofVertices it walk then plane (cornersOf it walk) else V.empty
    plane corners
      | n == zero || not (flatAlong n corners) = V.empty
      | otherwise =
        V.fromList
          [a `quot` g, b `quot` g, c `quot` g, dot n (firstOf corners) `quot` g]
      where
        n@(V3 a b c) = doubleArea corners
        g = gcd a (gcd b c)

-- | Cuts the faces with holes, if there are any, into faces without. There are two results: with as
-- few faces as grow from triangles, and with triangles. Each has, for every face, the index of the
-- original face.
withoutHoles :: Mesh -> [([Int], Mesh)]
withoutHoles it
  | any (holed . fst) cut = [(map (owners U.!) kept, grown), (U.toList owners, triangled)]
  | otherwise = []
  where
    (kept, grown) = mergedBut (IntSet.fromList [0 .. U.length owners - 1]) together triangled
    -- Each face without a hole gets a number of its own.
    together = U.fromList (concat [if holed f then f <$ own else [negate f - 1] | (f, own) <- cut])
    owners = U.fromList (concat [f <$ own | (f, own) <- cut])
    cut = [(f, parts f) | f <- [0 .. V.length (meshWalks it) - 1]]
    holed f = length (rims (U.toList (meshWalks it V.! f))) > 1
    parts f
      | holed f = [U.fromList [a, b, c] | (a, b, c) <- triangles it (meshWalks it V.! f)]
      | otherwise = [meshWalks it V.! f]
    triangled =
      withShape
        (V.take (V.length (meshPoints it)) (meshNames it))
        (meshDenominator it)
        (meshPoints it)
        (V.fromList (concatMap snd cut))
        it

-- | Merges faces with the same number that share sides.
mergeRegions :: U.Vector Int -> Mesh -> Mesh
mergeRegions may it
  | V.all (ofVertices it) (meshWalks it) = snd (mergedBut IntSet.empty may it)
  | otherwise = it

-- | 'mergeRegions', except that regions whose first face is listed grow face by face. Also returns,
-- for each resulting face, the first face that went into it.
mergedBut :: IntSet.IntSet -> U.Vector Int -> Mesh -> ([Int], Mesh)
mergedBut apart may it = fmap withoutUnused (unzip (settled apart))
  where
    sides = surface (meshWalks it)
    across s = case mateOf sides s of
      Just t
        | sideStart sides s /= sideStart sides t,
          may U.! sideFace sides s == may U.! sideFace sides t ->
          Just t
      _ -> Nothing
    regions =
      classes
        (V.length (meshWalks it))
        [ (sideFace sides s, sideFace sides t)
          | s <- [0 .. sideCount sides - 1],
            Just t <- [across s]
        ]
    members =
      IntMap.fromListWith
        (++)
        [ (regions U.! f, [f])
          | f <-
              [V.length (meshWalks it) - 1, V.length (meshWalks it) - 2 .. 0]
        ]
    -- The remaining faces, by the first face of each. Regions whose rims do not give one walk grow
    -- face by face.
    settled grown'
      | IntSet.null failing = [(f, walk) | (f, Just walk) <- walks]
      | otherwise = settled (IntSet.union failing grown')
      where
        faces = sortOn fst (concatMap (region grown') (IntMap.elems members))
        walks = zip (map fst faces) (map joinedRims (straightened (map snd faces)))
        failing = IntSet.fromList [f | (f, Nothing) <- walks]
    region grown' faces = case faces of
      [f] -> [(f, (False, [meshWalks it V.! f]))]
      f : _
        | IntSet.notMember f grown',
          Just loops <- rimsOf (IntSet.fromList faces) ->
          [(f, (True, loops))]
      _ -> [(f, (made, [walk])) | (f, (made, walk)) <- growing faces]
    joinedRims loops =
      bridged
        (meshPoints it V.!)
        (foldl' plus zero (map (doubleArea . cornersOf it) loops))
        loops
    -- The rims of some faces, if these visit no vertex twice.
    rimsOf faces
      | IntMap.size next == length rim = Just (map (fromFirst . U.fromList) (cycles next))
      | otherwise = Nothing
      where
        rim =
          [ s
            | f <- IntSet.toList faces,
              s <- sidesOfFace sides f,
              maybe True ((`IntSet.notMember` faces) . sideFace sides) (across s)
          ]
        next = IntMap.fromList [(sideStart sides s, sideEnd sides s) | s <- rim]
    cycles next = cyclesFrom (`IntMap.lookup` next) (IntMap.keys next)
    growing faces = case faces of
      [] -> []
      f : others ->
        let (own, walk) = grown (IntSet.fromList others) f
         in (f, (IntSet.size own > 1, if IntSet.size own > 1 then walk else meshWalks it V.! f)) :
            growing (filter (`IntSet.notMember` own) others)
    -- Faces across sides are tried in the order in which the sides came. Those that were refused
    -- are tried again as long as others are absorbed.
    grown free f =
      passing (IntSet.singleton f) (IntMap.fromList (cyclicSides (meshWalks it V.! f))) (near f)
      where
        near g = [sideFace sides t | s <- sidesOfFace sides g, Just t <- [across s]]
        passing own rim waiting =
          case foldl' trying (own, rim, [], []) waiting of
            (own', rim', left, new)
              | IntSet.size own' > IntSet.size own ->
                passing own' rim' (reverse left ++ reverse new)
              | otherwise -> (own', fromFirst (U.fromList (followed rim')))
        trying (own, rim, left, new) g
          | IntSet.member g own || IntSet.notMember g free = (own, rim, left, new)
          | otherwise = case joined rim (meshWalks it V.! g) of
            Just rim' -> (IntSet.insert g own, rim', left, reverse (near g) ++ new)
            Nothing -> (own, rim, g : left, new)
    -- The rim of a polygon and a face, if it is one walk that visits no vertex twice: their common
    -- sides follow each other, and they have no other common vertex.
    joined rim walk
      | null shared || length shared >= length own || length shared >= IntMap.size rim = Nothing
      | IntSet.size ends /= length shared + 1 = Nothing
      | any (`IntMap.member` rim) alone = Nothing
      | otherwise =
        Just
          ( foldl'
              (\now (a, b) -> IntMap.insert a b now)
              without
              [side | side <- own, side `notElem` shared]
          )
      where
        own = cyclicSides walk
        shared = [(a, b) | (a, b) <- own, IntMap.lookup b rim == Just a]
        alone = filter (`IntSet.notMember` ends) (U.toList walk)
        ends = IntSet.fromList (concat [[a, b] | (a, b) <- shared])
        without = foldl' (\now (_, b) -> IntMap.delete b now) rim shared
    cyclicSides = cyclicPairs . U.toList
    followed = concat . take 1 . cycles
    -- Without the vertices that are removed.
    straightened faces = [map (straightly made) loops | (made, loops) <- faces]
      where
        straightly made walk
          | U.length kept == U.length walk = if made then fromFirst walk else walk
          | U.length kept < 3 = walk
          | otherwise = fromFirst kept
          where
            kept = U.filter (`IntSet.notMember` gone) walk
        gone =
          IntSet.fromList
            [ v
              | (v, [(a, b), (c, d)]) <- IntMap.toList beside,
                a == d,
                b == c,
                straight (meshPoints it V.! a) (meshPoints it V.! v) (meshPoints it V.! b)
            ]
        beside =
          foldl'
            (\found (v, ends) -> IntMap.insertWith (++) v [ends] found)
            IntMap.empty
            [ (walk U.! i, (walk U.! ((i + n - 1) `mod` n), walk U.! ((i + 1) `mod` n)))
              | (_, loops) <- faces,
                walk <- loops,
                let n = U.length walk,
                i <- [0 .. n - 1]
            ]
    straight a v b =
      cross (a `minus` v) (b `minus` v) == zero && dot (a `minus` v) (b `minus` v) < 0
    withoutUnused walks =
      withShape
        (V.fromList (map (vertexAt it) kept))
        (meshDenominator it)
        (V.fromList (map (meshPoints it V.!) kept))
        (V.fromList (map (U.map (\v -> IntMap.findWithDefault v v places)) walks))
        it
      where
        before = usedBy (V.toList (meshWalks it))
        after = usedBy walks
        usedBy = IntSet.fromList . concatMap U.toList
        kept =
          mapMaybe
            (\v -> if IntSet.member v before && IntSet.notMember v after then Nothing else Just v)
            [0 .. V.length (meshPoints it) - 1]
        places = IntMap.fromList (zip kept [0 ..])

-- | The cycle begun at its least element.
fromFirst :: Walk -> Walk
fromFirst walk = U.drop k walk U.++ U.take k walk
  where
    k = U.minIndex walk
