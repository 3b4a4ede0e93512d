{-# OPTIONS_HADDOCK hide #-}

-- | The former places of objects, which a store remembers after they were taken out or replaced:
-- if the object now lies elsewhere, a part made for its former place is read as another part.
-- Stores without this table get it when there is something to remember.
module PraTactile.Store.Former
  ( Former,
    FormerFace (..),
    lyingNow,
    afterwards,
    elsewhere,

    -- * In the database
    rememberedBy,
    remember,
  )
where

import Control.Monad (unless, when)
import Control.Monad.Trans.Class (lift)
import Control.Monad.Trans.Except (except, throwE)
import Data.Foldable (for_)
import Data.Int (Int64)
import qualified Data.Map.Strict as Map
import qualified Data.Set as Set
import qualified Data.Text as Text
import Database.Persist.Sql
import Numeric.Natural (Natural)
import PraTactile.Array (Position (..), Shape (..))
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Store.Backend
import PraTactile.Store.Error
import PraTactile.Store.Query (Query)
import PraTactile.Store.Rows
import PraTactile.Store.Rows.Read
import PraTactile.Store.Rows.Write
import PraTactile.Store.Schema
import PraTactile.Store.Seal

-- | The faces of objects at their former places, by the objects' names.
type Former = Map.Map ObjectName [FormerFace]

-- | A face by the names of its corners, beginning where its frame begins, and its block on the
-- array.
data FormerFace = FormerFace
  { formerFace :: String,
    formerAt :: Position,
    formerGrid :: Shape
  }
  deriving stock (Eq, Ord, Show)

-- | The places of all objects with laid faces, the faces in the order of their names.
lyingNow :: Placement -> Former
lyingNow place =
  Set.toAscList . Set.fromList
    <$> Map.fromListWith
      (++)
      [ (faceObject face, [FormerFace (faceText (faceName face)) (laidAt laid) (laidGrid laid)])
        | laid <- laidFaces place,
          let face = laidFace laid
      ]

-- | The former places after one placement replaces another. The arguments are the objects that
-- were placed deliberately (nothing is remembered of them), the former places so far, and the
-- placements before and after. An object that is gone or lies elsewhere keeps its first place.
afterwards :: [ObjectName] -> Former -> Placement -> Placement -> Former
afterwards purposely known before now =
  Map.differenceWith different (before' `Map.withoutKeys` Set.fromList purposely) there
  where
    (here, there) = (lyingNow before, lyingNow now)
    -- Of several places the first is kept.
    before' = known <> Map.differenceWith different here there
    different was is = if was == is then Nothing else Just was

-- | The former places of objects that are new in a placement or have moved. The arguments are the
-- former places after the change, and the placements before and after.
elsewhere :: Former -> Placement -> Placement -> Former
elsewhere remembered before now = remembered `Map.intersection` moved
  where
    moved = Map.differenceWith different (lyingNow now) (lyingNow before)
    different is was = if is == was then Nothing else Just is

-- | The former places in a store.
rememberedBy :: Backend -> Query IO Former
rememberedBy backend = do
  there <- columnsOf backend (partName formerPart)
  if null there
    then pure Map.empty
    else do
      unless (there == map fst (partColumns formerPart)) $
        throwE (TablesDiffer (backendName backend))
      found <- lift (selectList [] [Desc StoredFormerObject, Desc StoredFormerNumber])
      rows' <- except (traverse (intact FormerTable . entityVal) found)
      Map.fromListWith (++) <$> traverse lay rows'
  where
    lay row' = do
      let number = except . natural FormerTable
      at <- Position <$> number (storedFormerAtRow row') <*> number (storedFormerAtColumn row')
      grid <- Shape <$> number (storedFormerGridRows row') <*> number (storedFormerGridColumns row')
      pure
        ( ObjectName (Text.unpack (storedFormerObject row')),
          [FormerFace (Text.unpack (storedFormerFace row')) at grid]
        )

-- | Replaces the former places in a store: the first ones by the second.
remember :: Backend -> Former -> Former -> Query IO ()
remember backend known now = do
  there <- columnsOf backend (partName formerPart)
  come <- except (formerRowsOf (changed now known))
  when (null there && not (null come)) (makeFormer backend)
  for_ (Map.keys (changed known now)) $ \name ->
    lift (deleteWhere [StoredFormerObject ==. Text.pack (objectText name)])
  lift (insertRows mempty {formerRows = come})
  where
    changed these those = Map.differenceWith other these those
    other this that = if this == that then Nothing else Just this

-- | The rows of former places.
formerRowsOf :: Former -> Either StoreError [StoredFormer]
formerRowsOf former =
  sequence
    [ sealed <$> row' (objectText name) number face
      | (name, faces') <- Map.toAscList former,
        (number, face) <- zip [0 ..] faces'
    ]
  where
    row' :: String -> Int64 -> FormerFace -> Either StoreError (Int64 -> StoredFormer)
    row' name number (FormerFace face at grid) =
      StoredFormer (Text.pack name) number (Text.pack face)
        <$> whole' (row at)
        <*> whole' (column at)
        <*> whole' (rows grid)
        <*> whole' (columns grid)
    whole' :: Natural -> Either StoreError Int64
    whole' = whole
