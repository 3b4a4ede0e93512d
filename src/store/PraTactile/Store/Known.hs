{-# LANGUAGE CPP #-}
{-# OPTIONS_GHC -O0 #-}
{-# OPTIONS_HADDOCK hide #-}

-- | The kind of database that a name means. Nothing of this module is inlined elsewhere, so the
-- static program, which has no PostgreSQL, can be linked with a replacement (@tools/static.sh@).
module PraTactile.Store.Known
  ( backendOf,
  )
where

import PraTactile.Store.Address
import PraTactile.Store.Backend (Backend)
import PraTactile.Store.Error (StoreError (..))
#ifdef POSTGRESQL
import PraTactile.Store.Postgresql (postgresql)
#endif
import PraTactile.Store.Sqlite (sqlite)

-- | The database with this name: on a server if it is an address, otherwise in a file.
backendOf :: String -> Either StoreError Backend
backendOf name
  | isAddress name = maybe (Left noAddress) onServer (readAddress name)
  | otherwise = Right (sqlite name)
  where
    noAddress = maybe UnreadableAddress UnknownScheme (unknownScheme name)

onServer :: Address -> Either StoreError Backend
#ifdef POSTGRESQL
onServer = Right . postgresql
#else
onServer = Left . WithoutServers . shownAddress
#endif
