-- | Decides the window property: whether all windows have different contents, so that the content
-- determines the position (MacWilliams and Sloane 1976; section II of the paper). There are two
-- methods: visiting every window, and the rank of the mask. Where both are possible they are
-- compared.
--
-- Costs: N is the number of a window's positions, m that of its cells, and n the degree of the
-- polynomial.
module PraTactile.Window.Proof
  ( -- * Proving
    prove,
    Proved,
    provedArray,
    provedMask,
    provedSurface,
    WindowVerdict (..),
    ProofError (..),

    -- * Any matrix
    proveGrid,

    -- * The two methods
    enumerate,
    Enumeration (..),
    allDistinct,
    EnumerationError (..),
    windowRank,
    windowVectors,
    windowsOfRank,
    rankOf,
  )
where

import Data.Bifunctor (first)
import Numeric.Natural (Natural)
import PraTactile.Array
import PraTactile.Field
import PraTactile.Grid
import PraTactile.Polynomial
import PraTactile.Window
import PraTactile.Window.Enumeration
import PraTactile.Window.Rank
import PraTactile.Window.Visit (visitedShape)

-- | What was found about the windows of a surface, and by which method.
data WindowVerdict = WindowVerdict
  { -- | whether all windows are distinct
    proved :: Bool,
    -- | the result of visiting every window; 'Nothing' if that was not done
    enumeration :: Maybe Bool,
    -- | the result by rank; 'Nothing' if the rank does not decide here
    rankDecision :: Maybe Bool,
    -- | the rank of the mask over GF(q); 'Nothing' for a matrix without a polynomial, or on a
    -- surface that is neither its own nor the sheet
    rank :: Maybe Natural,
    -- | n, the rank that suffices; 'Nothing' as for 'rank'
    needed :: Maybe Natural,
    -- | the number of different contents; 'Nothing' on a sheet too large to visit, if the rank is
    -- less than n
    distinctWindows :: Maybe Natural,
    -- | the surface whose windows they are
    surface :: Surface,
    -- | two positions with the same content, if every window was visited and such positions exist
    collision :: Maybe (Position, Position),
    -- | a position whose window is all zeros, if every window was visited and there is one
    zeroWindow :: Maybe Position
  }
  deriving stock (Eq, Show)

-- | Why there is no verdict.
data ProofError
  = -- | No window of this shape lies on the sheet.
    NoWindowOnSheet
  | -- | The rank does not decide here, and the array does not fit in memory to be visited.
    ArrayTooLarge FoldError
  | -- | The rank does not decide here, and a visit would take too much memory: this many possible
    -- contents at this many positions.
    WindowsTooMany Natural Natural
  | -- | The two methods contradict each other, which a theorem excludes. One of them is wrong, and
    -- neither can be trusted.
    MethodsDisagree WindowVerdict
  deriving stock (Eq, Show)

-- | An array with a mask and a surface on which all windows are proved to be distinct. Only 'prove'
-- makes one.
data Proved (k :: Field) = Proved
  { -- | The array.
    provedArray :: PseudorandomArray k,
    -- | The windows' shape.
    provedMask :: Mask,
    -- | The surface.
    provedSurface :: Surface
  }

type role Proved nominal

-- | Decides whether the windows are distinct on the surface, by both methods as far as possible. It
-- visits all windows if memory allows. It uses the rank on the array's 'naturalSurface', where the
-- rank decides, and on the sheet, where rank n is sufficient but not necessary. If the windows are
-- distinct, a 'Proved' comes with the verdict. Refuses if there is no window, if neither method is
-- possible, and if the two disagree. The costs are those of 'enumerate' and 'windowRank'.
prove ::
  KnownField k =>
  ArrayOn k ->
  Mask ->
  Either ProofError (WindowVerdict, Maybe (Proved k))
prove (ArrayOn on array) mask
  | area visits == 0 = Left NoWindowOnSheet
  | otherwise = case (visited, byRank) of
    (Left reason, Nothing) -> Left reason
    (Right seen, Just byTheorem)
      | (allDistinct seen, differentWindows seen) /= byTheorem -> Left (MethodsDisagree verdict)
    _ -> Right (verdict, if proved verdict then Just (Proved array mask on) else Nothing)
  where
    visits = visitedShape on (arrayShape array) mask
    -- An array that fits in memory is not made if its windows cannot be visited anyway.
    visited = case enumerable on (fieldOrder array) (arrayShape array) mask of
      Left refusal | area (arrayShape array) <= largestGrid -> Left (refused refusal)
      _ -> either (Left . ArrayTooLarge) (\grid -> visitAll on grid mask) (toGrid array)
    r = windowRank array mask
    n = fromIntegral (primitiveDegree (arrayPrimitive array))
    ownSurface = on == naturalSurface (arrayFolding array)
    -- Whether all windows are distinct, and the number of contents, as far as the rank decides.
    byRank
      | ownSurface = Just (r == n, windowsOfRank array r)
      | on == Sheet && r == n = Just (True, area visits)
      | otherwise = Nothing
    verdict =
      (either (const (unvisited on)) (verdictOf on) visited)
        { proved = either (const (maybe False fst byRank)) allDistinct visited,
          rankDecision = fst <$> byRank,
          rank = if ownSurface || on == Sheet then Just r else Nothing,
          needed = if ownSurface || on == Sheet then Just n else Nothing,
          distinctWindows = either (const (snd <$> byRank)) (Just . differentWindows) visited
        }

-- | Decides whether the windows of any matrix are distinct, by visiting them all. Refuses if there
-- is no window or too little memory. The cost is that of 'enumerate'.
proveGrid :: Surface -> Grid -> Mask -> Either ProofError WindowVerdict
proveGrid on grid mask = verdictOf on <$> visitAll on grid mask

visitAll :: Surface -> Grid -> Mask -> Either ProofError Enumeration
visitAll on grid mask = first refused (enumerate on grid mask)

refused :: EnumerationError -> ProofError
refused e = case e of
  NoWindow -> NoWindowOnSheet
  TooManyWindows contents positions -> WindowsTooMany contents positions

verdictOf :: Surface -> Enumeration -> WindowVerdict
verdictOf on seen =
  (unvisited on)
    { proved = allDistinct seen,
      enumeration = Just (allDistinct seen),
      distinctWindows = Just (differentWindows seen),
      collision = repeatedWindow seen,
      zeroWindow = zeroPosition seen
    }

unvisited :: Surface -> WindowVerdict
unvisited on =
  WindowVerdict
    { proved = False,
      enumeration = Nothing,
      rankDecision = Nothing,
      rank = Nothing,
      needed = Nothing,
      distinctWindows = Nothing,
      surface = on,
      collision = Nothing,
      zeroWindow = Nothing
    }
