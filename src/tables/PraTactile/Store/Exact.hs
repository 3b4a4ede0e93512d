{-# LANGUAGE OverloadedStrings #-}

-- | Rational numbers in a database: their digits as text, in lowest terms, @127/4@ or @-3@.
module PraTactile.Store.Exact
  ( Exact (..),
  )
where

import Data.Bifunctor (first)
import Data.Ratio (denominator, numerator, (%))
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Text.Read as Text
import Database.Persist (PersistField (..), PersistValue (..), SqlType (..))
import Database.Persist.Sql (PersistFieldSql (..))

-- | A rational number as a column's value.
newtype Exact = Exact {exactly :: Rational}
  deriving stock (Eq, Ord, Show)

instance PersistField Exact where
  toPersistValue = PersistText . written
  fromPersistValue value = do
    text <- fromPersistValue value
    number <- first Text.pack (signed text)
    -- Equal numbers have equal texts, so that any other text is damage.
    if written number == text then Right number else Left "a number that is not in lowest terms"
    where
      signed text = do
        (top, rest) <- Text.signed Text.decimal text
        case Text.uncons rest of
          Nothing -> Right (Exact (top % 1))
          Just ('/', below) -> do
            (bottom, end) <- Text.decimal below
            if bottom > 0 && Text.null end then Right (Exact (top % bottom)) else Left "no number"
          Just _ -> Left "no number"

instance PersistFieldSql Exact where
  sqlType _ = SqlString

written :: Exact -> Text
written (Exact r) =
  Text.pack (show (numerator r) ++ if denominator r == 1 then "" else '/' : show (denominator r))
